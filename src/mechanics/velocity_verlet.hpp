#pragma once

#include "mechanics/integrator.hpp"

namespace impact {

/// Velocity Verlet (W. C. Swope et al., J. Chem. Phys. 76 (1982) 637), with a predicted velocity
/// in the damping force:
///   v½    = vₙ + h aₙ/2
///   xₙ₊₁  = xₙ + h v½
///   aₙ₊₁  = F(xₙ₊₁, vₙ + h aₙ)/m
///   vₙ₊₁  = v½ + h aₙ₊₁/2
/// The prediction errs by O(h²), so the damped form keeps second order; taking v½ instead would
/// leave first order. Without damping the scheme is symplectic. One force evaluation a step.
///
/// A mode of frequency ω and damping rate γ (ẍ = −ω² x − γ ẋ) is stable while
///   h² ω²/4 + h γ ≤ 1,
/// the point at which an eigenvalue of the step matrix reaches −1: h ≤ 2/ω undamped, h ≤ 1/γ
/// overdamped.
template <class Field>
class BasicVelocityVerlet : public FixedStepIntegrator<Field> {
 public:
  static constexpr int kOrder = 2;
  using State = typename Field::State;

  void restart(Field& field, const State& state) override;
  void take_velocity(Field& field, const State& state) override;
  typename Field::Losses step(Field& field, State& state, typename Field::Step h) override;
  double step_limit(double omega_squared, double gamma) const override;

 private:
  using FixedStepIntegrator<Field>::force_;
  using FixedStepIntegrator<Field>::power_;
  typename Field::Points predicted_velocity_;  ///< empty without damping
};

using VelocityVerlet = BasicVelocityVerlet<ForceField>;

}  // namespace impact
