#pragma once

#include <memory>

#include "mechanics/motion.hpp"
#include "mechanics/static_equilibrium.hpp"
#include "mechanics/velocity_verlet.hpp"

namespace impact {

/// A motion that goes on by itself.
///
/// Where the field has a velocity reset, it acts at the end of each step that completes its
/// interval.
class Simulation : public Motion {
 public:
  /// `step` in R/c. It must be stable for the spectrum, see StepBound::step_limit(), and divide
  /// the interval of a velocity reset. An integrator that chooses steps by itself goes from one
  /// multiple of `step` to the next.
  Simulation(ForceField field, State initial, const Spectrum& spectrum, double step,
             std::unique_ptr<Integrator> integrator = std::make_unique<VelocityVerlet>());

  void step();

  /// Goes to the equilibrium at rest instead, see EquilibriumSolver. Its iterations count as
  /// steps, in step number and time. The energy that damped motion would have lost on the way is
  /// not known. False when none was found.
  bool settle(double tolerance);

  /// EquilibriumSolver::correction() of the present state.
  PointArray equilibrium_correction() const;

  /// Replaces the load of a scene with a potential wall by this one (M c²/R), moves the body to
  /// where the wall alone would then carry it, and counts time and steps from 0 again. For a series
  /// of static equilibria, each found from the one before.
  void reload(double p);

 private:
  double approach_speed() const;
  void reset_velocities();

  std::unique_ptr<Integrator> integrator_;
  std::unique_ptr<EquilibriumSolver> solver_ = std::make_unique<EquilibriumSolver>();
};

}  // namespace impact
