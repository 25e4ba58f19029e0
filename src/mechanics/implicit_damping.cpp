#include "mechanics/implicit_damping.hpp"

#include <cmath>

#include "mechanics/kick.hpp"

namespace impact {

template <class Field>
void BasicImplicitDamping<Field>::restart(Field& field, const State& state) {
  field.resize(force_);
  field.evaluate_undamped(state.position, force_);
}

template <class Field>
typename Field::Losses BasicImplicitDamping<Field>::step(Field& field, State& state,
                                                         typename Field::Step h) {
  const typename Field::Number half_step_by_mass = 0.5 * h / field.point_mass;
  middle_velocity_ = state.velocity;
  kick(half_step_by_mass, force_, middle_velocity_);
  typename Field::Losses losses;
  if (field.damped()) {
    damping_ = middle_velocity_;
    solver_.prepare(field, 0.5 * h);
    solver_.solve(middle_velocity_);
    damping_.array() -= middle_velocity_.array();
    losses.absorbed = h * field.boundary_power(middle_velocity_);
    losses.dissipated = 2.0 * field.point_mass * dot(middle_velocity_, damping_) - losses.absorbed;
  }
  kick(h, middle_velocity_, state.position);
  field.evaluate_undamped(state.position, force_);
  state.velocity = middle_velocity_;
  if (field.damped()) state.velocity.array() -= damping_.array();
  kick(half_step_by_mass, force_, state.velocity);
  return losses;
}

template <class Field>
double BasicImplicitDamping<Field>::step_limit(double omega_squared, double /*gamma*/) const {
  return 2.0 / std::sqrt(omega_squared);
}

template class BasicImplicitDamping<ForceField>;
template class BasicImplicitDamping<LaneField>;

}  // namespace impact
