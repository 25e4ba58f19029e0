#include "nodes/viewer_snapshot.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "nodes/body_topics.hpp"

namespace impact {
namespace {

constexpr std::size_t kMostStates = 16;  // of which a part has come

bool fit_together(const BodySnapshot& body) {
  if (!body.lattice || !body.states || body.lattice->run != body.states->run) return false;
  const std::size_t points = body.lattice->x.size();
  const auto are_points = [&](const std::vector<std::uint32_t>& indices) {
    return indices.size() == body.lattice->natural_length.size() &&
           std::all_of(indices.begin(), indices.end(), [&](auto index) { return index < points; });
  };
  return points > 0 && body.states->x.size() == points && body.states->y.size() == points &&
         body.states->vx.size() == points && body.states->vy.size() == points &&
         are_points(body.lattice->bond_first) && are_points(body.lattice->bond_second);
}

bool fit(const lattice_impact::ContactForces& forces, const lattice_impact::ParticleStates& on) {
  return forces.fx.size() == forces.point.size() && forces.fy.size() == forces.point.size() &&
         std::all_of(forces.point.begin(), forces.point.end(),
                     [&](auto point) { return point < on.x.size(); });
}

}  // namespace

/// The disk's begins a run, perhaps of another simulation, which counts from 0 again.
void SnapshotAssembly::add(const lattice_impact::LatticeConstPtr& lattice) {
  for (std::size_t body = 0; body < kMostBodies; ++body) {
    if (lattice->name == name_of_body(body)) lattices_[body] = lattice;
  }
  if (lattice->name == name_of_body(0)) states_.clear();
}

void SnapshotAssembly::add(const lattice_impact::RunStatusConstPtr& status) { status_ = status; }

template <class Message>
SnapshotAssembly::State& SnapshotAssembly::state_of(const Message& message) {
  if (states_.size() == kMostStates) states_.erase(states_.begin());
  return states_[{message.run, message.sequence}];
}

void SnapshotAssembly::add(std::size_t body, const lattice_impact::ParticleStatesConstPtr& states) {
  state_of(*states).bodies[body] = states;
}

void SnapshotAssembly::add(const lattice_impact::ContactForcesConstPtr& forces) {
  state_of(*forces).forces = forces;
}

std::optional<Snapshot> SnapshotAssembly::take() {
  for (auto state = states_.rbegin(); state != states_.rend(); ++state) {
    auto snapshot = snapshot_of(state->second);
    if (!snapshot) continue;
    states_.erase(states_.begin(), std::prev(state.base()));
    const auto newest = std::pair(snapshot->disk.states, snapshot->status);
    return std::exchange(taken_, newest) == newest ? std::nullopt : snapshot;
  }
  return std::nullopt;
}

std::optional<Snapshot> SnapshotAssembly::snapshot_of(const State& state) const {
  const auto& disk = state.bodies.front();
  Snapshot snapshot{{lattices_.front(), disk}, state.forces, {}, status_};
  if (!fit_together(snapshot.disk) || !state.forces || !fit(*state.forces, *disk) || !status_ ||
      status_->run != disk->run) {
    return std::nullopt;
  }
  for (std::size_t body = 1; body < bodies_said(status_->bodies); ++body) {
    snapshot.others.push_back({lattices_[body], state.bodies[body]});
    if (!fit_together(snapshot.others.back())) return std::nullopt;
  }
  return snapshot;
}

}  // namespace impact
