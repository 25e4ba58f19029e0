#pragma once

#include <array>

#include "mechanics/implicit_damping.hpp"
#include "mechanics/integrator.hpp"

namespace impact {

/// ImplicitDamping over each step in one, two and four parts, extrapolated to parts of no length
/// (Aitken–Neville, local extrapolation: E. Hairer, S. P. Nørsett and G. Wanner, Solving Ordinary
/// Differential Equations I, 1993, II.9). The error of the symmetric scheme has even powers of the
/// step only, so that three columns give order 6. Eight force evaluations and seven linear
/// solutions a step.
///
/// In one, two and four parts, not in one, two and three: the mid-step rule turns the sign of an
/// overdamped mode once a part, and the weights 1/45, −20/45 and
/// 64/45 of this sequence leave of it 43/45 at most, however strong the damping. Without damping a
/// mode grows by less than 10⁻³ a step up to ω h = 1.5; with γ ≥ 0.03 ω² h, as all modes of a
/// lattice have whose bonds are damped that much, all is stable up to ω h = 3.
template <class Field>
class BasicExtrapolatedDamping : public FixedStepIntegrator<Field> {
 public:
  static constexpr int kOrder = 6;
  static constexpr double kUndampedLimit = 1.5;   ///< of ω h
  static constexpr double kDampedLimit = 3.0;     ///< of ω h
  static constexpr double kEnoughDamping = 0.03;  ///< of γ/(ω² h)
  using State = typename Field::State;

  void restart(Field& field, const State& state) override;
  void take_velocity(Field& /*field*/, const State& /*state*/) override {}
  typename Field::Losses step(Field& field, State& state, typename Field::Step h) override;
  double step_limit(double omega_squared, double gamma) const override;

 private:
  using FixedStepIntegrator<Field>::force_;  ///< without damping

  struct Column {
    int parts;
    BasicImplicitDamping<Field> integrator;
    State state;
    typename Field::Losses losses;
  };
  /// Removes the leading error that both columns have.
  static void extrapolate(const Column& coarse, double weight, Column& fine);

  std::array<Column, 3> columns_{Column{1, {}, {}, {}}, Column{2, {}, {}, {}},
                                 Column{4, {}, {}, {}}};
};

using ExtrapolatedDamping = BasicExtrapolatedDamping<ForceField>;

}  // namespace impact
