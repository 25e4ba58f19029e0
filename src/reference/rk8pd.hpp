#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "mechanics/first_order_form.hpp"
#include "mechanics/integrator.hpp"

namespace impact {

/// The embedded Runge–Kutta pair of orders 8 and 9 with 13 stages (P. J. Prince and J. R. Dormand,
/// J. Comput. Appl. Math. 7 (1981) 67) as GSL has it, gsl_odeiv2_step_rk8pd: the reference that
/// shares nothing with the other integrators but the forces.
///   yₙ₊₁ = yₙ + h Σ bᵢ kᵢ,   kᵢ = f(yₙ + h Σⱼ aᵢⱼ kⱼ), j < i,   y = (x, v, energies lost)
/// The step is chosen so that the difference of the two formulas stays below the tolerance in every
/// component; the solution goes on with order 8, and its error falls in proportion to the
/// tolerance.
///
/// Explicit: where stability limits the step (ω h and γ h of about 5), it is found by rejecting
/// steps, and stiff damping is slow.
class Rk8pd : public Integrator {
 public:
  /// `tolerance` of the error of one inner step, in units of `scales`. `most_inner_steps`: of one
  /// step(), before it gives up.
  Rk8pd(double tolerance, const Scales& scales,
        std::uint64_t most_inner_steps = std::numeric_limits<std::uint64_t>::max());
  Rk8pd(const Rk8pd&) = delete;
  Rk8pd& operator=(const Rk8pd&) = delete;
  ~Rk8pd() override;

  void restart(ForceField& field, const State& state) override;
  void take_velocity(ForceField& field, const State& state) override;
  /// @throw std::runtime_error when no step is short enough, or too many are needed.
  Losses step(ForceField& field, State& state, double h) override;
  double step_limit(double omega_squared, double gamma) const override;

 private:
  class Solver;

  double tolerance_;
  Scales scales_;
  std::uint64_t most_inner_steps_;
  std::unique_ptr<Solver> solver_;
};

}  // namespace impact
