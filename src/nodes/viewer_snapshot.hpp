#pragma once

#include <lattice_impact/ContactForces.h>
#include <lattice_impact/Lattice.h>
#include <lattice_impact/ParticleStates.h>
#include <lattice_impact/RunStatus.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "mechanics/body.hpp"

namespace impact {

/// A lattice and a state of it.
struct BodySnapshot {
  lattice_impact::LatticeConstPtr lattice;
  lattice_impact::ParticleStatesConstPtr states;
};

/// All that is drawn of one state.
struct Snapshot {
  BodySnapshot disk;
  lattice_impact::ContactForcesConstPtr forces;  ///< on the disk's points
  std::vector<BodySnapshot> others;              ///< what the disk meets, if made of points
  lattice_impact::RunStatusConstPtr status;      ///< the latest of the run
};

/// Puts the messages of several topics together, of which any may be missing, and keeps the newest
/// state of which everything has come.
class SnapshotAssembly {
 public:
  void add(const lattice_impact::LatticeConstPtr& lattice);
  void add(const lattice_impact::RunStatusConstPtr& status);
  /// Of the body of this number; 0: the disk.
  void add(std::size_t body, const lattice_impact::ParticleStatesConstPtr& states);
  void add(const lattice_impact::ContactForcesConstPtr& forces);

  /// The newest state, if it or the status of its run has come since the last call.
  std::optional<Snapshot> take();

 private:
  struct State {
    std::array<lattice_impact::ParticleStatesConstPtr, kMostBodies> bodies;
    lattice_impact::ContactForcesConstPtr forces;
  };
  using Position = std::pair<std::uint32_t, std::uint32_t>;  // run, sequence

  template <class Message>
  State& state_of(const Message& message);
  std::optional<Snapshot> snapshot_of(const State& state) const;

  std::array<lattice_impact::LatticeConstPtr, kMostBodies> lattices_;
  lattice_impact::RunStatusConstPtr status_;
  std::map<Position, State> states_;  ///< the newest that is whole, and those after it
  std::pair<lattice_impact::ParticleStatesConstPtr, lattice_impact::RunStatusConstPtr> taken_;
};

}  // namespace impact
