#pragma once

#include <array>
#include <memory>

#include "mechanics/integrator.hpp"
#include "mechanics/lane_field.hpp"
#include "mechanics/simulation.hpp"

namespace impact {

class LaneBundle;

/// A motion that goes on by itself or, while it is there, in a lane of a bundle.
class LaneMotion : public Simulation {
 public:
  /// Of a field that lanes know, see LaneField::knows().
  LaneMotion(ForceField field, State initial, const Spectrum& spectrum, double step,
             std::unique_ptr<FixedStepIntegrator<ForceField>> integrator);
  LaneMotion(const LaneMotion&) = delete;
  LaneMotion& operator=(const LaneMotion&) = delete;
  /// Leaves the bundle.
  ~LaneMotion() override;

  bool is_in_bundle() const { return bundle_ != nullptr; }
  /// A step off the bundle.
  using Simulation::step;
  /// Leaves the bundle, if it is in one.
  void leave();
  const State& state() const override;
  double kinetic_energy() const override;

 private:
  friend class LaneBundle;

  FixedStepIntegrator<ForceField>* alone_;
  LaneBundle* bundle_ = nullptr;
  int lane_ = 0;
  double approach_ = 0.0;           ///< as Simulation::approach_speed()
  double squared_speed_ = 0.0;      ///< Σ v², c²
  mutable bool is_current_ = true;  ///< the positions and velocities of the state
};

/// Up to kLanes motions on one lattice that advance side by side, one step of each at a time. None
/// is changed by the others in the slightest, however they come and go.
class LaneBundle {
 public:
  /// `lattice`: of the disk and, after it, an elastic wall. The integrator is of the kind that the
  /// motions have. `needs_common_step`: whether the
  /// integrator takes the same step, damping and supports for granted in all lanes.
  LaneBundle(const Lattice& lattice, double point_mass, LaneField::Kind kind,
             std::unique_ptr<FixedStepIntegrator<LaneField>> integrator, bool needs_common_step);
  LaneBundle(const LaneBundle&) = delete;
  LaneBundle& operator=(const LaneBundle&) = delete;
  /// All leave, as they are.
  ~LaneBundle();

  bool is_full() const { return occupied_ == kLanes; }

  /// Puts a motion in a free lane, where it stays until it leaves, to the end of its life or of
  /// the bundle's at most.
  void add(LaneMotion& motion);

  /// A step of every motion in it. One whose step has to be halved, when the integrator needs a
  /// common one, leaves instead.
  void step();

 private:
  friend class LaneMotion;

  void take_step(LaneMotion& motion, const LaneLosses& lost, std::uint64_t evaluations);
  void reset_velocities(LaneMotion& motion);
  void release(LaneMotion& motion);
  void look_at_speeds();
  void read(int lane, State& state) const;

  LaneField field_;
  LaneState state_;
  std::unique_ptr<FixedStepIntegrator<LaneField>> integrator_;
  bool needs_common_step_;
  LaneNumbers step_size_ = LaneNumbers::Zero();
  std::array<LaneMotion*, kLanes> motions_{};
  int occupied_ = 0;
};

}  // namespace impact
