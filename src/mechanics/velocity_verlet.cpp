#include "mechanics/velocity_verlet.hpp"

#include <cmath>

namespace impact {

void VelocityVerlet::restart(ForceField& field, const State& state) {
  acceleration_.resizeLike(state.position);
  if (field.damped()) predicted_velocity_.resizeLike(state.velocity);
  power_ = field.evaluate(state.position, state.velocity, acceleration_);
  acceleration_ /= field.point_mass;
}

void VelocityVerlet::take_velocity(ForceField& field, const State& state) {
  if (field.damped()) restart(field, state);
}

Losses VelocityVerlet::step(ForceField& field, State& state, double h) {
  const bool damped = field.damped();
  if (damped) predicted_velocity_ = state.velocity + h * acceleration_;
  state.velocity += (0.5 * h) * acceleration_;
  state.position += h * state.velocity;

  const Losses before = power_;
  power_ =
      field.evaluate(state.position, damped ? predicted_velocity_ : state.velocity, acceleration_);
  acceleration_ /= field.point_mass;
  state.velocity += (0.5 * h) * acceleration_;
  return {0.5 * h * (before.dissipated + power_.dissipated),
          0.5 * h * (before.absorbed + power_.absorbed)};
}

double VelocityVerlet::step_limit(double omega_squared, double gamma) const {
  return 2.0 / (gamma + std::sqrt(gamma * gamma + omega_squared));
}

}  // namespace impact
