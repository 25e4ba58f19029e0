#include "mechanics/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace impact {
namespace {

/// Holds the frequency of a point against the wall to half the stability limit.
constexpr double kWallMargin = 4.0;

}  // namespace

Simulation::Simulation(ForceField field, State initial, const Spectrum& spectrum, double step)
    : field_(std::move(field)),
      state_(std::move(initial)),
      spectrum_(spectrum),
      integrator_(field_, state_),
      step_size_(step) {}

void Simulation::step() {
  if (field_.wall) watch_wall();
  dissipated_ += integrator_.step(field_, state_, step_size_);
  ++ticks_;
  ++state_.step;
  state_.time = static_cast<double>(ticks_) * step_size_;
}

bool Simulation::settle(double tolerance) {
  const EquilibriumSearch search = find_equilibrium(field_, state_.position, tolerance);
  state_.velocity.setZero();
  ticks_ += static_cast<std::uint64_t>(search.iterations);
  state_.step += static_cast<std::uint64_t>(search.iterations);
  state_.time = static_cast<double>(ticks_) * step_size_;
  return search.found;
}

void Simulation::watch_wall() {
  const PotentialWall& wall = *field_.wall;
  const double approach = std::max(0.0, -state_.velocity.col(1).minCoeff());
  const auto limit = [&] {
    const double force = wall.largest_force() * std::exp(wall.a() * approach * step_size_);
    const double omega_squared =
        spectrum_.omega_squared + kWallMargin * wall.stiffness(force) / field_.point_mass;
    return verlet_step_limit(omega_squared, spectrum_.gamma);
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
  field.evaluate(state_.position, PointArray::Zero(state_.position.rows(), 2), force);
  return force.abs().maxCoeff();
}

}  // namespace impact
