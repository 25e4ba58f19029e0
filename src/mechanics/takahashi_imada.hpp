#pragma once

#include "mechanics/integrator.hpp"

namespace impact {

/// Velocity Verlet with a corrected force (M. Takahashi and M. Imada, J. Phys. Soc. Jpn. 53 (1984)
/// 3765), taken at displaced positions in place of second derivatives (J. Wisdom, M. Holman and J.
/// Touma, Fields Inst. Commun. 10 (1996) 217; E. Hairer, R. I. McLachlan and R. D. Skeel, ESAIM:
/// M2AN 43 (2009) 631):
///   v½    = vₙ + h aₙ/2
///   xₙ₊₁  = xₙ + h v½
///   aₙ₊₁  = F(xₙ₊₁ + h² F(xₙ₊₁)/12m)/m
///   vₙ₊₁  = v½ + h aₙ₊₁/2
/// Two force evaluations a step. The method is symmetric in time, and of order 4 seen from where no
/// forces act to where none do any more: what an impact leaves of momentum, angular momentum and
/// energy errs by O(h⁴). In between, positions and velocities are off by O(h²), to and fro: those
/// of a method of order 4 are x + h² F/12m, and so the forces of the last evaluation, which are
/// those at such positions, err by O(h⁴) again.
///
/// Its order rests on forces that change smoothly, do not depend on velocities (a damped field is
/// refused), and act on no point at the start and the end: gravity and the pull in a spinning disk
/// displace x from where the method of order 4 has it.
///
/// The harmonic oscillator of frequency ω moves as one with ω² (1 − ω² h²/12) under velocity
/// Verlet, stable up to ω h = √12.
template <class Field>
class BasicTakahashiImada : public FixedStepIntegrator<Field> {
 public:
  static constexpr int kOrder = 4;
  using State = typename Field::State;

  /// @throw std::invalid_argument when the field is damped.
  void restart(Field& field, const State& state) override;
  void take_velocity(Field& /*field*/, const State& /*state*/) override {}
  typename Field::Losses step(Field& field, State& state, typename Field::Step h) override;
  double step_limit(double omega_squared, double gamma) const override;

 private:
  using FixedStepIntegrator<Field>::force_;
  typename Field::Points displaced_;
};

using TakahashiImada = BasicTakahashiImada<ForceField>;

}  // namespace impact
