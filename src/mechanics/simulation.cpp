#include "mechanics/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace impact {
namespace {

/// Against an elastic wall, which doubles the square of the frequency.
constexpr double kBothEndsMove = 2.0;

}  // namespace

Simulation::Simulation(ForceField field, State initial, const Spectrum& spectrum, double step,
                       std::unique_ptr<Integrator> integrator)
    : field_(std::move(field)),
      state_(std::move(initial)),
      spectrum_(spectrum),
      integrator_(std::move(integrator)),
      step_size_(step) {
  integrator_->restart(field_, state_);
}

void Simulation::step() {
  if (const WallContact* const wall = field_.contact()) watch_wall(*wall);
  const Losses lost = integrator_->step(field_, state_, step_size_);
  if (field_.elastic_wall) field_.elastic_wall->count_hops(state_.position);
  losses_.dissipated += lost.dissipated;
  losses_.absorbed += lost.absorbed;
  ++ticks_;
  ++state_.step;
  state_.time = static_cast<double>(ticks_) * step_size_;
  if (field_.velocity_reset) reset_velocities();
}

void Simulation::reset_velocities() {
  const VelocityReset& reset = *field_.velocity_reset;
  const auto steps = static_cast<std::uint64_t>(std::llround(reset.interval() / step_size_));
  if (ticks_ % steps != 0) return;
  losses_.absorbed += reset.apply(state_.velocity, field_.point_mass);
  integrator_->take_velocity(field_, state_);
}

bool Simulation::settle(double tolerance) {
  const EquilibriumSearch search = find_equilibrium(field_, state_.position, tolerance);
  state_.velocity.setZero();
  ticks_ += static_cast<std::uint64_t>(search.iterations);
  state_.step += static_cast<std::uint64_t>(search.iterations);
  state_.time = static_cast<double>(ticks_) * step_size_;
  return search.found;
}

void Simulation::reload(double p) {
  const WallContact& wall = *field_.wall;
  state_.position.col(1) += wall.gap_of_force(p) - wall.gap_of_force(field_.load->p());
  field_.load.emplace(p);
  ticks_ = 0;
  state_.step = 0;
  state_.time = 0.0;
}

double Simulation::approach_speed() const {
  const auto upwards = state_.velocity.col(1);
  const Eigen::Index of_wall = field_.wall_points;
  const double down = std::max(0.0, -upwards.head(upwards.rows() - of_wall).minCoeff());
  return of_wall == 0 ? down : down + std::max(0.0, upwards.tail(of_wall).maxCoeff());
}

void Simulation::watch_wall(const WallContact& wall) {
  const double approach = approach_speed();
  const double margin = kWallMargin * (field_.elastic_wall ? kBothEndsMove : 1.0);
  const auto limit = [&] {
    const double force = wall.largest_force() * std::exp(wall.a() * approach * step_size_);
    const double omega_squared =
        spectrum_.omega_squared + margin * wall.stiffness(force) / field_.point_mass;
    return integrator_->step_limit(omega_squared, spectrum_.gamma);
  };
  while (step_size_ > limit()) {
    step_size_ /= 2.0;
    ticks_ *= 2;
    ++halvings_;
  }
}

double Simulation::largest_static_force() const {
  ForceField field = field_;
  PointArray force(state_.position.rows(), 2);
  field.evaluate_undamped(state_.position, force);
  return force.abs().maxCoeff();
}

}  // namespace impact
