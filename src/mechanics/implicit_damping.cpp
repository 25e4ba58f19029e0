#include "mechanics/implicit_damping.hpp"

#include <cmath>

namespace impact {

void ImplicitDamping::restart(ForceField& field, const State& state) {
  force_.resizeLike(state.position);
  field.evaluate_undamped(state.position, force_);
}

Losses ImplicitDamping::step(ForceField& field, State& state, double h) {
  const bool damped = field.damped();
  if (damped && solver_step_ != h) {
    solver_.emplace(field, 0.5 * h);
    solver_step_ = h;
  }
  const double half_step_by_mass = 0.5 * h / field.point_mass;
  start_ = state.velocity + half_step_by_mass * force_;
  middle_velocity_ = start_;
  Losses losses;
  if (damped) {
    solver_->solve(middle_velocity_);
    // h D v½ = 2 m (start − v½)
    const double lost =
        2.0 * field.point_mass * (middle_velocity_ * (start_ - middle_velocity_)).sum();
    if (field.viscous_boundary)
      losses.absorbed = h * field.viscous_boundary->power(middle_velocity_);
    losses.dissipated = lost - losses.absorbed;
  }
  state.position += h * middle_velocity_;
  field.evaluate_undamped(state.position, force_);
  state.velocity = 2.0 * middle_velocity_ - start_ + half_step_by_mass * force_;
  return losses;
}

double ImplicitDamping::step_limit(double omega_squared, double /*gamma*/) const {
  return 2.0 / std::sqrt(omega_squared);
}

}  // namespace impact
