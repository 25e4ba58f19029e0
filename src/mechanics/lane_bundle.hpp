#pragma once

#include <array>
#include <functional>
#include <memory>

#include "mechanics/integrator.hpp"
#include "mechanics/lane_field.hpp"
#include "mechanics/motion.hpp"

namespace impact {

class LaneBundle;

/// A motion that goes on in a lane of a bundle. Off the bundle it stands still.
class LaneMotion : public Motion {
 public:
  /// As Simulation, of a field that lanes know, see LaneField::knows().
  LaneMotion(ForceField field, State initial, const Spectrum& spectrum, double step);
  LaneMotion(const LaneMotion&) = delete;
  LaneMotion& operator=(const LaneMotion&) = delete;
  /// Leaves the bundle.
  ~LaneMotion() override;

  bool is_in_bundle() const { return bundle_ != nullptr; }
  const State& state() const override;
  double kinetic_energy() const override;

 private:
  friend class LaneBundle;

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
  using MakeIntegrator = std::function<std::unique_ptr<FixedStepIntegrator<LaneField>>()>;

  /// `lattice`: of the disk and, after it, an elastic wall. `needs_common_step`: whether the
  /// integrator takes the same step and damping for granted in all lanes.
  LaneBundle(const Lattice& lattice, double point_mass, LaneField::Kind kind,
             const MakeIntegrator& make_integrator, bool needs_common_step);
  LaneBundle(const LaneBundle&) = delete;
  LaneBundle& operator=(const LaneBundle&) = delete;
  /// All leave, as they are.
  ~LaneBundle();

  bool is_full() const { return occupied_ == kLanes; }

  /// Puts a motion in a free lane, where it stays until it leaves, to the end of its life or of
  /// the bundle's at most.
  void add(LaneMotion& motion);
  void leave(LaneMotion& motion);

  /// A step of every motion in it. One whose step has to be halved, when the integrator needs a
  /// common one, leaves instead.
  void step();

 private:
  friend class LaneMotion;

  void take_step(LaneMotion& motion, const LaneLosses& lost, std::uint64_t evaluations);
  void look_at_speeds();
  void read(int lane, State& state) const;

  LaneField field_;
  LaneState state_;
  std::unique_ptr<FixedStepIntegrator<LaneField>> integrator_;
  std::unique_ptr<FixedStepIntegrator<LaneField>> beginner_;  ///< to begin in a single lane
  bool needs_common_step_;
  LaneNumbers step_size_ = LaneNumbers::Zero();
  std::array<LaneMotion*, kLanes> motions_{};
  int occupied_ = 0;
};

}  // namespace impact
