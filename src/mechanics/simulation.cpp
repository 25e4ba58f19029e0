#include "mechanics/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace impact {

Simulation::Simulation(ForceField field, State initial, const Spectrum& spectrum, double step,
                       std::unique_ptr<Integrator> integrator)
    : Motion(std::move(field), std::move(initial), spectrum, step),
      integrator_(std::move(integrator)) {
  integrator_->restart(field_, state_);
}

void Simulation::step() {
  if (const Contact* const wall = field_.contact()) {
    limit_step(*wall, approach_speed(), *integrator_);
  }
  const Losses lost = integrator_->step(field_, state_, step_size_);
  field_.count_hops(state_.position);
  count_step(lost);
  if (reset_is_due()) reset_velocities();
}

void Simulation::reset_velocities() {
  losses_.absorbed += field_.velocity_reset->apply(state_.velocity, field_.point_mass);
  integrator_->take_velocity(field_, state_);
}

double Simulation::approach_speed() const {
  const auto upwards = state_.velocity.col(1);
  const Eigen::Index of_second = field_.second_points();
  const double down = -kernels().least(upwards.data(), upwards.size() - of_second);
  return of_second == 0 ? down : down + std::max(0.0, upwards.tail(of_second).maxCoeff());
}

}  // namespace impact
