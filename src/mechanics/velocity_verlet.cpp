#include "mechanics/velocity_verlet.hpp"

#include <cmath>

#include "mechanics/kick.hpp"

namespace impact {

template <class Field>
void BasicVelocityVerlet<Field>::restart(Field& field, const State& state) {
  field.resize(force_);
  if (field.damped()) field.resize(predicted_velocity_);
  power_ = field.evaluate(state.position, state.velocity, force_);
}

template <class Field>
void BasicVelocityVerlet<Field>::take_velocity(Field& field, const State& state) {
  if (field.damped()) restart(field, state);
}

template <class Field>
typename Field::Losses BasicVelocityVerlet<Field>::step(Field& field, State& state,
                                                        typename Field::Step h) {
  const typename Field::Number half_kick = 0.5 * h / field.point_mass;
  if (!field.damped()) {
    field.evaluate_undamped(
        state.position, force_,
        [&](const PointRows& rows) {
          kick_and_drift(rows, half_kick, force_, h, state.velocity, state.position);
        },
        [&](const PointRows& rows) { kick(rows, half_kick, force_, state.velocity); });
    return {};
  }
  predicted_velocity_ = state.velocity;
  kick(h / field.point_mass, force_, predicted_velocity_);
  kick_and_drift(half_kick, force_, h, state.velocity, state.position);

  const typename Field::Losses before = power_;
  power_ = field.evaluate(state.position, predicted_velocity_, force_);
  kick(half_kick, force_, state.velocity);
  return {0.5 * h * (before.dissipated + power_.dissipated),
          0.5 * h * (before.absorbed + power_.absorbed)};
}

template <class Field>
double BasicVelocityVerlet<Field>::step_limit(double omega_squared, double gamma) const {
  return 2.0 / (gamma + std::sqrt(gamma * gamma + omega_squared));
}

template class BasicVelocityVerlet<ForceField>;
template class BasicVelocityVerlet<LaneField>;

}  // namespace impact
