#include "mechanics/imex.hpp"

#include <cmath>
#include <stdexcept>

#include "mechanics/kick.hpp"

namespace impact {

void Imex::restart(ForceField& field, const State& state) {
  if (!field.unstrained) throw std::invalid_argument("Imex: no unstrained positions");
  arm_ = field.unstrained->rowwise() - field.unstrained->colwise().mean();
  turned_arm_.resize(arm_.rows(), 2);
  turned_arm_.col(0) = -arm_.col(1);
  turned_arm_.col(1) = arm_.col(0);
  field.resize(force_);
  field.resize(damping_);
  field.evaluate_undamped(state.position, force_);
}

Losses Imex::step(ForceField& field, State& state, double h) {
  const double half_kick = 0.5 * h / field.point_mass;
  const double angle = middle_angle(state, h);
  kick(half_kick, force_, state.velocity);
  middle_velocity_ = state.velocity;
  solver_.prepare(field, 0.5 * h);
  const Eigen::Array2d mean = middle_velocity_.colwise().mean();
  middle_velocity_.rowwise() -= mean.transpose();
  turn(-angle, middle_velocity_);
  solver_.solve(middle_velocity_);
  turn(angle, middle_velocity_);
  middle_velocity_.rowwise() += mean.transpose();
  kick(h, middle_velocity_, state.position);

  Losses lost;
  if (field.damped()) {
    const Losses power = field.evaluate_damping(middle_velocity_, damping_);
    lost = {h * power.dissipated, h * power.absorbed};
    kick(2.0 * half_kick, damping_, state.velocity);
  }
  field.evaluate_undamped(state.position, force_);
  kick(half_kick, force_, state.velocity);
  return lost;
}

double Imex::middle_angle(const State& state, double h) const {
  const auto component = [&](const PointArray& along) {
    return dot(state.position, along) + 0.5 * h * dot(state.velocity, along);
  };
  return std::atan2(component(turned_arm_), component(arm_));
}

double Imex::step_limit(double omega_squared, double /*gamma*/) const {
  return 2.0 / std::sqrt(omega_squared);
}

}  // namespace impact
