#pragma once

#include "mechanics/force_field.hpp"
#include "mechanics/state.hpp"

namespace impact {

/// Velocity Verlet (W. C. Swope et al., J. Chem. Phys. 76 (1982) 637), with a predicted velocity
/// in the damping force:
///   v½    = vₙ + h aₙ/2
///   xₙ₊₁  = xₙ + h v½
///   aₙ₊₁  = F(xₙ₊₁, vₙ + h aₙ)/m
///   vₙ₊₁  = v½ + h aₙ₊₁/2
/// The prediction errs by O(h²), so the damped form keeps second order; taking v½ instead would
/// leave first order. Without damping the scheme is symplectic.
///
/// A mode of frequency ω and damping rate γ (ẍ = −ω² x − γ ẋ) is stable while
///   h² ω²/4 + h γ ≤ 1,
/// the point at which an eigenvalue of the step matrix reaches −1: h ≤ 2/ω undamped, h ≤ 1/γ
/// overdamped.
class VelocityVerlet {
 public:
  /// Evaluates the forces at the initial state.
  VelocityVerlet(ForceField& field, const State& state);

  /// Evaluates the forces anew, at a state that was changed from outside.
  void evaluate(ForceField& field, const State& state);

  /// Advances position and velocity by h (R/c) with one force evaluation; leaves time and step
  /// count to the caller. Returns the energy lost (M c², trapezoidal rule).
  Losses step(ForceField& field, State& state, double h);

 private:
  PointArray acceleration_;
  PointArray predicted_velocity_;  ///< empty without damping
  Losses power_;
};

/// Largest stable step (R/c) for modes up to frequency² `omega_squared` (c²/R²) and damping rate
/// up to `gamma` (c/R).
double verlet_step_limit(double omega_squared, double gamma);

}  // namespace impact
