#include "mechanics/takahashi_imada.hpp"

#include <cmath>
#include <stdexcept>

#include "mechanics/kick.hpp"

namespace impact {
namespace {

constexpr double kCorrection = 1.0 / 12.0;

}  // namespace

template <class Field>
void BasicTakahashiImada<Field>::restart(Field& field, const State& state) {
  if (field.damped()) throw std::invalid_argument("TakahashiImada: forces depend on velocities");
  field.resize(force_);
  field.resize(displaced_);
  field.evaluate(state.position, state.velocity, force_);
}

template <class Field>
typename Field::Losses BasicTakahashiImada<Field>::step(Field& field, State& state,
                                                        typename Field::Step h) {
  const typename Field::Number half_kick = 0.5 * h / field.point_mass;
  const typename Field::Number correction = kCorrection * h * h / field.point_mass;
  field.evaluate_undamped(
      state.position, force_,
      [&](const PointRows& rows) {
        kick_and_drift(rows, half_kick, force_, h, state.velocity, state.position);
      },
      [&](const PointRows& rows) {
        displace(rows, correction, force_, state.position, displaced_);
      });
  field.evaluate_undamped(
      displaced_, force_, [](const PointRows& /*rows*/) {},
      [&](const PointRows& rows) { kick(rows, half_kick, force_, state.velocity); });
  return {};
}

template <class Field>
double BasicTakahashiImada<Field>::step_limit(double omega_squared, double /*gamma*/) const {
  return 1.0 / std::sqrt(kCorrection * omega_squared);
}

template class BasicTakahashiImada<ForceField>;
template class BasicTakahashiImada<LaneField>;

}  // namespace impact
