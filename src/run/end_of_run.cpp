#include "run/end_of_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace impact {
namespace {

constexpr double kLookInterval = 1.0;  // R/c

}  // namespace

SeparationEnd::SeparationEnd(double negligible_energy, double sound_speed)
    : negligible_energy_(negligible_energy), waiting_time_(5.0 / sound_speed) {}

bool SeparationEnd::reached(const Simulation& simulation) {
  // The potential V₀ exp(−a y) is its force over a.
  const PotentialWall& wall = *simulation.field().wall;
  const State& state = simulation.state();
  if (wall.total_force() / wall.a() > negligible_energy_) {
    touched_ = true;
    last_touch_ = state.time;
  }
  return touched_ && state.time - last_touch_ > waiting_time_ && state.velocity.col(1).sum() > 0.0;
}

RestEnd::RestEnd(const Scene& scene, Eigen::Index points, double step)
    : largest_force_(negligible_static_force(scene, points, step)),
      largest_speed_(
          std::max(0.1 * scene.numerics.error * scene.load.p / std::sqrt(scene.material.k_a),
                   4.0 * std::numeric_limits<double>::epsilon() / step)) {}

bool RestEnd::reached(const Simulation& simulation) {
  if (simulation.state().time < next_look_) return false;
  next_look_ += kLookInterval;
  return simulation.state().velocity.abs().maxCoeff() <= largest_speed_ &&
         simulation.largest_static_force() <= largest_force_;
}

double negligible_static_force(const Scene& scene, Eigen::Index points, double step) {
  constexpr double kRounding = 2e-15;
  const double share = 1.0 / static_cast<double>(points);
  double rounding = kRounding * scene.material.k_a;
  if (scene.numerics.integrator != IntegratorKind::kNewton) {
    const double eta = scene.material.eta * share;
    rounding += 12.0 * eta * std::numeric_limits<double>::epsilon() / step;
  }
  return std::max(0.1 * scene.numerics.error * scene.load.p * share, rounding);
}

std::unique_ptr<EndOfRun> end_of_run(const Scene& scene, const Composition& composition) {
  if (scene.kind == SceneKind::kContact) {
    return std::make_unique<RestEnd>(scene, composition.lattice.points.rows(), composition.step);
  }
  return std::make_unique<SeparationEnd>(negligible_wall_energy(scene), composition.sound_speed);
}

}  // namespace impact
