#pragma once

#include <optional>

#include "mechanics/damping_solver.hpp"
#include "mechanics/integrator.hpp"

namespace impact {

/// Velocity Verlet with the damping at the mid-step velocity, which it determines implicitly; for
/// damping too stiff for explicit steps. With aₙ the acceleration without damping and D the
/// constant damping matrix:
///   (1 + h D/2m) v½ = vₙ + h aₙ/2
///   xₙ₊₁ = xₙ + h v½
///   vₙ₊₁ = v½ + h aₙ₊₁/2 − h D v½/2m = 2 v½ − vₙ + h (aₙ₊₁ − aₙ)/2
/// The two half steps of the velocity are implicit and explicit Euler steps of the damping, adjoint
/// to each other: the scheme is symmetric and of order 2 (the Crank–Nicolson treatment of damping
/// in a leapfrog; E. Hairer, C. Lubich and G. Wanner, Geometric Numerical Integration, 2006,
/// II.3). One force evaluation and one solution of the constant linear system a step; its
/// Cholesky factor is made anew when h changes. Without damping it is velocity Verlet.
///
/// Stable for ω h < 2, whatever the damping.
class ImplicitDamping : public Integrator {
 public:
  static constexpr int kOrder = 2;

  void restart(ForceField& field, const State& state) override;
  void take_velocity(ForceField& /*field*/, const State& /*state*/) override {}
  Losses step(ForceField& field, State& state, double h) override;
  double step_limit(double omega_squared, double gamma) const override;

  /// Takes over the force from one at the same state.
  void start_like(const ImplicitDamping& other) { force_ = other.force_; }

 private:
  PointArray force_;  ///< without damping
  PointArray middle_velocity_;
  PointArray start_;  ///< vₙ + h aₙ/2
  std::optional<DampingSolver> solver_;
  double solver_step_ = 0.0;
};

}  // namespace impact
