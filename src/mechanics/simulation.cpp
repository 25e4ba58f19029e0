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
  const double* const upwards = state_.velocity.col(1).data();
  double down = -kernels().least(upwards, field_.first_body().points);
  if (field_.others.empty()) return down;
  double approach = 0.0;
  for (const Body& other : field_.others) {
    const auto of_other = other.rows_of(state_.velocity).col(1);
    approach = std::max(approach, down + std::max(0.0, of_other.maxCoeff()));
    down = std::max(down, -kernels().least(upwards + other.first, other.points));
  }
  return approach;
}

}  // namespace impact
