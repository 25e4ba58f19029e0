#include "statics/equilibrium_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "statics/equilibrium_solver.hpp"

namespace impact {
namespace {

/// Loads that crush the disk, P = 1, take 400 to 600.
constexpr std::uint64_t kMostSteps = 2000;
constexpr double kLeastLimit = 3.0;  // of a move, in ranges 1/a of the wall
constexpr double kGoodGain = 0.7;    // of the energy that the slope promises
constexpr double kGrowth = 1.5;
constexpr double kSufficientDecrease = 1e-4;  // of the slope (Armijo)
constexpr int kMostHalvings = 40;
constexpr double kFirstShift = 1e-6;
constexpr int kMostShifts = 8;  // each ten times the one before
constexpr int kShiftsBack = 2;  // from one step to the next

}  // namespace

EquilibriumSearch::EquilibriumSearch(ForceField field, State initial, double tolerance)
    : System(std::move(field), std::move(initial), 1.0),
      tolerance_(tolerance),
      force_(state_.position.rows(), 2),
      largest_force_(evaluate()),
      least_limit_(field_.wall ? kLeastLimit / field_.wall->a()
                               : std::numeric_limits<double>::infinity()),
      limit_(least_limit_),
      ends_(found()) {}

double EquilibriumSearch::evaluate() {
  field_.evaluate_undamped(state_.position, force_);
  return force_.abs().maxCoeff();
}

double EquilibriumSearch::shift() const {
  return attempt_ == 0 ? 0.0 : kFirstShift * std::pow(10.0, attempt_ - 1);
}

void EquilibriumSearch::take(const Vector& solution, const Vector& response, double scale) {
  Vector step = solution;
  if (field_.hold) {
    const Eigen::Map<const Vector> direction(field_.hold->direction().data(), step.size());
    step -= response * (direction.dot(step) / direction.dot(response));
  }
  const double slope = step.dot(force());
  if (slope > 0.0 && std::isfinite(slope)) {
    keeps_factors_ = attempt_ == 0;
    go(shaped(step));
  } else if (attempt_ < kMostShifts) {
    ++attempt_;
    needs_stiffness_ = false;
  } else {
    keeps_factors_ = false;
    go(force_ / scale);
  }
}

/// As points, without a free shift or what rounding has left of a held rotation where that is soft,
/// and within the limit.
PointArray EquilibriumSearch::shaped(const Vector& step) const {
  PointArray moves = Eigen::Map<const PointArray>(step.data(), force_.rows(), 2);
  if (field_.hold) field_.hold->take_out_rotation(moves);
  for (const int axis : {0, 1}) {
    if (field_.shifts_freely(axis)) moves.col(axis) -= moves.col(axis).mean();
  }
  return moves * std::min(1.0, limit_ / moves.abs().maxCoeff());
}

void EquilibriumSearch::go(const PointArray& step) {
  attempt_ = std::max(0, attempt_ - kShiftsBack);
  needs_stiffness_ = true;
  if (ends_) {
    correction_ = step;
    finished_ = true;
    return;
  }
  ++state_.step;
  state_.time += step_size();
  const bool advanced = line_search(step);
  ends_ = !advanced || found() || steps() == kMostSteps;
  if (ends_) attempt_ = 0;
}

/// Goes along `step` as far as energy falls enough or, where energy is lost in rounding, as the
/// largest force falls. False when neither happens.
bool EquilibriumSearch::line_search(const PointArray& step) {
  PointArray& position = state_.position;
  const PointArray start = position;
  const double energy_at_start = field_.potential_energy(start);
  const double slope = -(step * force_).sum();
  double length = 1.0;
  for (int k = 0; k < kMostHalvings; ++k) {
    position = start + length * step;
    const double gain = (field_.potential_energy(position) - energy_at_start) / (length * slope);
    const double force = evaluate();
    if (gain > kSufficientDecrease || force < largest_force_) {
      largest_force_ = force;
      limit_moves(length, gain, length * step.abs().maxCoeff());
      return true;
    }
    length /= 2.0;
  }
  position = start;
  largest_force_ = evaluate();
  return false;
}

/// After a step of this length, on which the energy fell by so much of what its slope promised.
void EquilibriumSearch::limit_moves(double length, double gain, double move) {
  if (length < 1.0) {
    limit_ = std::max(least_limit_, move);
  } else if (gain > kGoodGain) {
    limit_ = std::max(limit_, kGrowth * move);
  }
}

PointArray equilibrium_correction(const ForceField& field, const State& state) {
  EquilibriumSearch search(field, state, std::numeric_limits<double>::infinity());
  solve(search);
  return search.correction();
}

}  // namespace impact
