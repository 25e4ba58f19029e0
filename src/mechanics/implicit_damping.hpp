#pragma once

#include "mechanics/integrator.hpp"
#include "mechanics/lane_velocity_solver.hpp"
#include "mechanics/velocity_solver.hpp"

namespace impact {

/// Velocity Verlet with the damping at the mid-step velocity, which it determines implicitly; for
/// damping too stiff for explicit steps. With aₙ the acceleration without damping and D the
/// constant damping matrix:
///   (1 + h D/2m) v½ = vₙ + h aₙ/2
///   xₙ₊₁ = xₙ + h v½
///   vₙ₊₁ = v½ − h D v½/2m + h aₙ₊₁/2,   h D v½/2m = vₙ + h aₙ/2 − v½
/// The two half steps of the velocity are implicit and explicit Euler steps of the damping, adjoint
/// to each other: the scheme is symmetric and of order 2 (the Crank–Nicolson treatment of damping
/// in a leapfrog; E. Hairer, C. Lubich and G. Wanner, Geometric Numerical Integration, 2006,
/// II.3). One force evaluation and one solution of the constant linear system a step; its
/// Cholesky factor is made anew when h changes. Without damping it is velocity Verlet.
///
/// Stable for ω h < 2, whatever the damping.
template <class Field>
class BasicImplicitDamping : public FixedStepIntegrator<Field> {
 public:
  static constexpr int kOrder = 2;
  using State = typename Field::State;

  void restart(Field& field, const State& state) override;
  void take_velocity(Field& /*field*/, const State& /*state*/) override {}
  typename Field::Losses step(Field& field, State& state, typename Field::Step h) override;
  double step_limit(double omega_squared, double gamma) const override;

  /// Begins with this force at the present state, without damping.
  void start_with(const typename Field::Points& force) { force_ = force; }

 private:
  using FixedStepIntegrator<Field>::force_;  ///< without damping
  typename Field::Points middle_velocity_;
  typename Field::Points damping_;  ///< h D v½/2m
  typename Field::VelocitySolver solver_;
};

using ImplicitDamping = BasicImplicitDamping<ForceField>;

}  // namespace impact
