#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernels/lanes.hpp"
#include "lattice/lattice.hpp"
#include "mechanics/force_field.hpp"
#include "mechanics/losses.hpp"

namespace impact {

class LaneVelocitySolver;

/// The forces of kLanes runs of one lattice, as ForceField has them for one, at a potential wall
/// or against points. Every run has constants of its own. A bond
/// is evaluated once, in all lanes at a time. The forces of each run are those of ForceField to the
/// last bit, whatever is in the other lanes.
class LaneField {
 public:
  using Number = LaneNumbers;
  using Step = const LaneNumbers&;
  using Points = LaneArray;
  using State = LaneState;
  using Losses = LaneLosses;
  using VelocitySolver = LaneVelocitySolver;

  /// What all runs have in common, besides the lattice.
  struct Kind {
    bool cubic = false;
    bool damped = false;
    bool own_terms = false;  ///< what acts on each lane by itself, in place of a potential wall
  };
  static Kind kind_of(const ForceField& field) {
    return {field.bonds.law().k_b != 0.0, field.damped(), !field.wall};
  }
  /// Whether lanes take over all terms of the field, see set_lane().
  static bool knows(const ForceField& field);

  LaneField(const Lattice& lattice, double mass, Kind kind,
            const Kernels& kernels = impact::kernels());

  /// Puts a field of this kind in a lane. Its terms of its own go on there.
  /// @throw std::logic_error for a term that lanes do not know: it would be missing from the
  /// motion.
  void set_lane(int lane, ForceField& field);
  /// In an empty lane nothing acts.
  void clear_lane(int lane);

  /// As in ForceField. A power is that of each run.
  LaneLosses evaluate(const LaneArray& position, const LaneArray& velocity, LaneArray& force);
  void evaluate_undamped(const LaneArray& position, LaneArray& force);

  template <class Place, class Use>
  void evaluate_undamped(const LaneArray& position, LaneArray& force, const Place& place,
                         const Use& use) {
    const PointRows all{0, points_};
    place(all);
    evaluate_undamped(position, force);
    use(all);
  }

  bool damped() const { return kind_.damped; }
  void resize(LaneArray& points) const { points.resize(points_); }
  /// There is no boundary.
  static LaneNumbers boundary_power(const LaneArray& /*velocity*/) { return LaneNumbers::Zero(); }

  /// Of the potential wall on the disk in the last evaluation.
  WallForce wall_force(int lane) const { return {wall_total_(lane), wall_largest_(lane)}; }

  /// The field that came last into a lane.
  const ForceField& latest() const { return *latest_; }

  double point_mass;              ///< M
  std::uint64_t evaluations = 0;  ///< so far

 private:
  void take(int lane, const PotentialWall& wall);
  // These act on each lane by themselves.
  void take(int /*lane*/, const SurfaceContact& /*contact*/) {}
  void take(int /*lane*/, const DiskContacts& /*contacts*/) {}
  void take(int /*lane*/, const Supports& /*supports*/) {}
  void take(int /*lane*/, const VelocityReset& /*reset*/) {}
  void add_own_terms(const LaneArray& position, LaneArray& force);
  LaneNumbers evaluate(bool damped, const LaneArray& position, const double* velocity,
                       LaneArray& force);

  Kind kind_;
  const LaneKernels* kernels_;
  Eigen::Index points_;
  std::vector<std::int32_t> begin_;  ///< as in BondList
  std::vector<std::int32_t> end_;
  std::vector<double> natural_length_;
  LaneArray relative_speeds_squared_;  ///< as in LaneEvaluation; empty without damping
  LaneNumbers k_a_;
  LaneNumbers k_b_;
  LaneNumbers eta_;
  LaneNumbers wall_a_;
  LaneNumbers wall_force_at_zero_;
  LaneNumbers wall_reach_;
  LaneNumbers wall_total_;
  LaneNumbers wall_largest_;
  std::array<ForceField*, kLanes> fields_{};  ///< nullptr: an empty lane
  std::optional<ForceField> latest_;          ///< with damping
};

}  // namespace impact
