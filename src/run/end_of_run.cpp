#include "run/end_of_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "run/expected_time.hpp"

namespace impact {
namespace {

constexpr double kLookInterval = 1.0;  // R/c
constexpr std::uint64_t kLookSteps = 16;
constexpr double kLongestWay = 10.0;     // R
constexpr double kLeastVelocity = 1e-3;  // of that before

}  // namespace

SeparationEnd::SeparationEnd(const Scene& scene, const Composition& composition)
    : velocity_before_(composition.field.reduced_mass() * scene.impact.normal_velocity()),
      negligible_energy_(negligible_fraction(scene) *
                         impact_energy(scene, composition.field.reduced_mass())),
      remaining_(remaining_fraction(scene)),
      flight_(scene, composition.bodies) {}

bool SeparationEnd::reached(const System& system) {
  // The potential V₀ exp(−a y) is its force over a.
  const ForceField& field = system.field();
  const Contact& contact = *field.contact();
  const double energy = contact.total_force().y() / contact.a();
  if (energy > negligible_energy_) {
    touched_ = true;
    return false;
  }
  if (!touched_ || system.steps() % kLookSteps != 0) return false;
  const double v = field.first_body().rows_of(system.state().velocity).col(1).mean();
  time_under_way_ = std::max(
      time_under_way_, kLongestWay / std::max(std::abs(v), kLeastVelocity * velocity_before_));
  const double bound = flight_.energy_bound(system, remaining_);
  if (!std::isfinite(bound)) return false;
  remaining_ = bound;
  return true;
}

RestEnd::RestEnd(const Scene& scene, Eigen::Index points, double step)
    : largest_force_(negligible_static_force(scene, points, step)),
      largest_speed_(
          std::max(0.1 * scene.numerics.error * scene.load.p / std::sqrt(scene.material.k_a),
                   4.0 * std::numeric_limits<double>::epsilon() / step)) {}

bool RestEnd::reached(const System& system) {
  if (system.time() < next_look_) return false;
  next_look_ += kLookInterval;
  return system.state().velocity.abs().maxCoeff() <= largest_speed_ &&
         system.largest_static_force() <= largest_force_;
}

double negligible_static_force(const Scene& scene, Eigen::Index points, double step) {
  constexpr double kRounding = 2e-15;
  const double rounding_of_bonds = kRounding * scene.material.k_a;
  if (scene.kind == SceneKind::kStretch) {
    const double x = std::abs(scene.stretch.strain) * std::sqrt(M_PI / scene.disk.recipe.points);
    const double stiffness = scene.material.k_a + 3.0 * scene.material.k_b * x * x;
    return stiffness * std::max(0.01 * scene.numerics.error * x, kRounding);
  }
  const double share = 1.0 / static_cast<double>(points);
  double rounding = rounding_of_bonds;
  if (!scene.is_static()) {
    const double eta = scene.material.eta * share;
    rounding += 12.0 * eta * std::numeric_limits<double>::epsilon() / step;
  }
  return std::max(0.1 * scene.numerics.error * scene.load.p * share, rounding);
}

std::unique_ptr<EndOfRun> end_of_run(const Scene& scene, const Composition& composition,
                                     double step) {
  const Eigen::Index points = composition.bodies->disk().points.rows();
  if (scene.is_static()) {
    return std::make_unique<StaticEnd>(negligible_static_force(scene, points, step));
  }
  if (scene.kind == SceneKind::kContact) return std::make_unique<RestEnd>(scene, points, step);
  return std::make_unique<SeparationEnd>(scene, composition);
}

}  // namespace impact
