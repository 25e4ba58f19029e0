#pragma once

#include <memory>

#include "mechanics/first_order_form.hpp"
#include "mechanics/integrator.hpp"

namespace impact {

/// The backward differentiation formulas (C. W. Gear, Numerical Initial Value Problems in Ordinary
/// Differential Equations, 1971) of orders 1 to 5 with variable step, as in CVODE of SUNDIALS (A.
/// C. Hindmarsh et al., ACM Trans. Math. Softw. 31 (2005) 363); for the stiffest damping, and for
/// motion that comes to rest. With y = (x, v, energies lost) and order q,
///   Σᵢ₌₀…q αᵢ yₙ₋ᵢ + hₙ β f(yₙ) = 0,
/// solved for yₙ by a modified Newton method: M (y⁺ − y) = −g(y), M = 1 − γ ∂f/∂y, γ = hₙ β/α₀.
/// M stays as it is, factorised (see ReducedSystem), until γ has changed by 30 %, twenty steps have
/// gone by or Newton's method no longer converges: a little more than one force evaluation and one
/// solution a step.
///
/// CVODE chooses step and order so that its estimate of a step's error stays below the tolerance;
/// the error of the answer is some ten to a hundred times that and falls with it. It steps past
/// the end of step() and interpolates with the order of the method, so that its own steps may be
/// longer. After take_velocity() it starts anew at order 1.
///
/// Orders 1 and 2 are A-stable, order 5 stable within 51° of the negative real axis: overdamped
/// modes never limit the step. Where weakly damped ones do, CVODE's stability limit detection (A.
/// C. Hindmarsh, LLNL report UCRL-100081, 1989) lowers the order: a pressed disk comes to rest in a
/// third to a fifth of the evaluations. Undamped modes lose energy at order 1 and 2 and need short
/// steps: there other integrators are better.
class Bdf : public Integrator {
 public:
  /// `tolerance` of a step's error, in root mean square over the components of y, each in units of
  /// its scale.
  Bdf(double tolerance, const Scales& scales);
  Bdf(const Bdf&) = delete;
  Bdf& operator=(const Bdf&) = delete;
  ~Bdf() override;

  void restart(ForceField& field, const State& state) override;
  void take_velocity(ForceField& field, const State& state) override;
  /// @throw std::runtime_error when the solver cannot go on.
  Losses step(ForceField& field, State& state, double h) override;
  double step_limit(double omega_squared, double gamma) const override;

 private:
  class Solver;

  double tolerance_;
  Scales scales_;
  std::unique_ptr<Solver> solver_;
};

}  // namespace impact
