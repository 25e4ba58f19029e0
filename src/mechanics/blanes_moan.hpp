#pragma once

#include "mechanics/integrator.hpp"

namespace impact {

/// The symplectic Runge–Kutta–Nyström method SRKN11b of order 6 (S. Blanes and P. C. Moan, J.
/// Comput. Appl. Math. 142 (2002) 313): eleven drifts x += a_i h v between twelve kicks
/// v += b_i h F(x)/m, symmetric in time. The first kick of a step uses the force of the last one
/// before it: eleven force evaluations a step.
///
/// Its order rests on forces that do not depend on velocities: a damped field is refused.
///
/// The harmonic oscillator of frequency ω is stable up to ω h = 9.07, save for two narrow
/// resonances: 3.1415 … 3.1424, where it grows by at most 5·10⁻⁴ a step, and 6.3479 … 6.3493, by
/// 7·10⁻⁴. In an impact, some hundred steps long, they do not show.
template <class Field>
class BasicBlanesMoan : public FixedStepIntegrator<Field> {
 public:
  static constexpr int kOrder = 6;
  static constexpr double kLimit = 9.07;  ///< of ω h
  using State = typename Field::State;

  /// @throw std::invalid_argument when the field is damped.
  void restart(Field& field, const State& state) override;
  void take_velocity(Field& /*field*/, const State& /*state*/) override {}
  typename Field::Losses step(Field& field, State& state, typename Field::Step h) override;
  double step_limit(double omega_squared, double gamma) const override;

 private:
  using FixedStepIntegrator<Field>::force_;
};

using BlanesMoan = BasicBlanesMoan<ForceField>;

}  // namespace impact
