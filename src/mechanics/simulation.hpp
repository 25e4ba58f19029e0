#pragma once

#include <memory>

#include "mechanics/energy_ledger.hpp"
#include "mechanics/force_field.hpp"
#include "mechanics/integrator.hpp"
#include "mechanics/spectrum.hpp"
#include "mechanics/state.hpp"
#include "mechanics/static_equilibrium.hpp"
#include "mechanics/velocity_verlet.hpp"

namespace impact {

/// A scene in motion: its state, the forces on it, its integrator and step.
///
/// The wall grows stiffer the deeper a point is pressed into it. Before each step the integrator's
/// stability bound is looked at with 1.5 times the stiffness a F of the largest force that a point
/// may meet in that step, F exp(a v h) with the greatest speed v at which a point of the disk and
/// one of the wall may approach. The step is halved from there on while it exceeds the bound.
///
/// Where the field has a velocity reset, it acts at the end of each step that completes its
/// interval.
class Simulation {
 public:
  /// Times the stiffness of the wall: for what the force may grow beyond the forecast.
  static constexpr double kWallMargin = 1.5;

  /// `step` in R/c. It must be stable for the spectrum, see Integrator::step_limit(), and divide
  /// the interval of a velocity reset. An integrator that chooses steps by itself goes from one
  /// multiple of `step` to the next.
  Simulation(ForceField field, State initial, const Spectrum& spectrum, double step,
             std::unique_ptr<Integrator> integrator = std::make_unique<VelocityVerlet>());

  void step();

  /// Goes to the equilibrium at rest instead, see find_equilibrium(). Its iterations count as
  /// steps, in step number and time. The energy that damped motion would have lost on the way is
  /// not known. False when none was found.
  bool settle(double tolerance);

  /// Replaces the load of a scene with a potential wall by this one (M c²/R), moves the body to
  /// where the wall alone would then carry it, and counts time and steps from 0 again. For a series
  /// of static equilibria, each found from the one before.
  void reload(double p);

  const State& state() const { return state_; }
  const ForceField& field() const { return field_; }
  double step_size() const { return step_size_; }
  /// How many times the step was halved.
  int halvings() const { return halvings_; }

  EnergyLedger ledger() const { return energy_ledger(field_, state_, losses_); }

  /// Largest component, over all points, of the force on a point at rest in the present
  /// configuration, in M c²/R.
  double largest_static_force() const;

 private:
  void watch_wall(const WallContact& wall);
  double approach_speed() const;
  void reset_velocities();

  ForceField field_;
  State state_;
  Spectrum spectrum_;
  std::unique_ptr<Integrator> integrator_;
  double step_size_;
  std::uint64_t ticks_ = 0;  ///< time in units of the present step
  int halvings_ = 0;
  Losses losses_;
};

}  // namespace impact
