#include "mechanics/velocity_verlet.hpp"

#include <cmath>

#include "mechanics/kick.hpp"

namespace impact {

void VelocityVerlet::restart(ForceField& field, const State& state) {
  force_.resizeLike(state.position);
  if (field.damped()) predicted_velocity_.resizeLike(state.velocity);
  power_ = field.evaluate(state.position, state.velocity, force_);
}

void VelocityVerlet::take_velocity(ForceField& field, const State& state) {
  if (field.damped()) restart(field, state);
}

Losses VelocityVerlet::step(ForceField& field, State& state, double h) {
  const bool damped = field.damped();
  if (damped) {
    predicted_velocity_ = state.velocity;
    kick(h / field.point_mass, force_, predicted_velocity_);
  }
  const double half_kick = 0.5 * h / field.point_mass;
  kick_and_drift(half_kick, force_, h, state.velocity, state.position);

  const Losses before = power_;
  power_ = field.evaluate(state.position, damped ? predicted_velocity_ : state.velocity, force_);
  kick(half_kick, force_, state.velocity);
  return {0.5 * h * (before.dissipated + power_.dissipated),
          0.5 * h * (before.absorbed + power_.absorbed)};
}

double VelocityVerlet::step_limit(double omega_squared, double gamma) const {
  return 2.0 / (gamma + std::sqrt(gamma * gamma + omega_squared));
}

}  // namespace impact
