#pragma once

#include <cstdint>

#include "mechanics/energy_ledger.hpp"
#include "mechanics/force_field.hpp"
#include "mechanics/integrator.hpp"
#include "mechanics/spectrum.hpp"
#include "mechanics/state.hpp"

namespace impact {

/// A scene in motion: its state, the forces on it and its step.
///
/// The wall grows stiffer the deeper a point is pressed into it. So the integrator's stability
/// bound is checked before each step, with 1.5 times the stiffness a F of the largest force that a
/// point may meet in that step: F exp(a v h), v being the greatest speed at which a point of the
/// disk and one of the wall may approach each other. While the step exceeds the bound, it is halved
/// for good.
class Motion {
 public:
  /// Times the stiffness of the wall: for what the force may grow beyond the forecast.
  static constexpr double kWallMargin = 1.5;

  virtual ~Motion() = default;

  virtual const State& state() const { return state_; }
  double time() const { return state_.time; }          ///< of the state, R/c
  std::uint64_t steps() const { return state_.step; }  ///< of the state
  const ForceField& field() const { return field_; }
  double step_size() const { return step_size_; }
  /// How many times the step was halved.
  int halvings() const { return halvings_; }

  virtual double kinetic_energy() const;  ///< of all points, M c²
  EnergyLedger ledger() const { return field_.ledger(state(), losses_); }

  /// Largest component, over all points, of the force on a point at rest in the present
  /// configuration, in M c²/R.
  double largest_static_force() const;

 protected:
  Motion(ForceField field, State initial, const Spectrum& spectrum, double step);

  /// Halves the step until it is stable. `approach`: speed (c) of wall and disk towards each other.
  void limit_step(const WallContact& wall, double approach, const StepBound& bound);
  void count_step(const Losses& lost);
  /// Whether the step that was counted last completes an interval of the field's velocity reset.
  bool reset_is_due() const;

  ForceField field_;
  mutable State state_;  ///< while in a lane, with positions and velocities of an earlier step
  Spectrum spectrum_;
  double step_size_;
  std::uint64_t ticks_ = 0;  ///< time in units of the present step
  int halvings_ = 0;
  Losses losses_;
};

}  // namespace impact
