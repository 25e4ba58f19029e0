#include "mechanics/imex.hpp"

#include <cmath>

#include "mechanics/kick.hpp"

namespace impact {

void Imex::restart(ForceField& field, const State& state) {
  solver_.emplace(field);
  field.resize(force_);
  field.resize(differences_);
  field.evaluate_undamped(state.position, force_);
}

Losses Imex::step(ForceField& field, State& state, double h) {
  const double half_kick = 0.5 * h / field.point_mass;
  const double angle = middle_angle(state, h);
  kick(half_kick, force_, state.velocity);
  middle_velocity_ = state.velocity;
  solver_->prepare(h);
  turn(-angle, middle_velocity_);
  solver_->solve(middle_velocity_, differences_);

  Losses lost;
  if (field.damped()) {
    const double viscosity = field.bonds.law().eta;
    lost.dissipated = h * viscosity * dot(middle_velocity_, differences_);
    turn(angle, differences_);
    kick(-2.0 * half_kick * viscosity, differences_, state.velocity);
  }
  turn(angle, middle_velocity_);
  kick(h, middle_velocity_, state.position);
  field.evaluate_undamped(state.position, force_);
  kick(half_kick, force_, state.velocity);
  return lost;
}

double Imex::middle_angle(const State& state, double h) const {
  const auto component = [&](const PointArray& along) {
    return dot(state.position, along) + 0.5 * h * dot(state.velocity, along);
  };
  return std::atan2(component(solver_->rotation()), component(solver_->arm()));
}

double Imex::step_limit(double omega_squared, double /*gamma*/) const {
  return 2.0 / std::sqrt(omega_squared);
}

}  // namespace impact
