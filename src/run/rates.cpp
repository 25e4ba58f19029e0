#include "run/rates.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/motion.hpp"
#include "run/expected_time.hpp"
#include "theory/hertz.hpp"

namespace impact {
namespace {

/// The energy of the impact, M v²/2, goes into the disk, P²/2k with k = M (π/τ)², and the wall,
/// P/a.
double largest_force_of_impact(const Scene& scene, double sound_speed) {
  const double v = scene.impact.normal_velocity();
  const double frequency = M_PI / contact_time_at_most(sound_speed, v);
  const double depth = 1.0 / scene.wall.a;
  return v * v / (depth + std::hypot(depth, v / frequency));
}

/// Of the disk against what it meets, 1/R.
double curvature(const Scene& scene) {
  return scene.hits_disk() ? 1.0 + 1.0 / scene.wall.radius : 1.0;
}

}  // namespace

double largest_point_force(const Scene& scene, int points, double sound_speed) {
  double total = 2.0 * scene.load.p;
  double stopping_one_point = 0.0;
  if (scene.kind == SceneKind::kCollision) {
    const double v = scene.impact.normal_velocity();
    total = largest_force_of_impact(scene, sound_speed);
    stopping_one_point = 0.5 * scene.wall.a * v * v / points;
  }
  const ElasticDisk disk{sound_speed * sound_speed / M_PI, 0.0};
  const double hard = contact_pressure(disk, total, 0.0);
  const double soft = total * std::sqrt(scene.wall.a * curvature(scene) / (2.0 * M_PI));
  const double pressure = hard * soft / std::hypot(hard, soft);
  const double share = std::min(total, 2.0 * pressure * std::sqrt(M_PI / points));
  return std::max(share, stopping_one_point);
}

Rates rates(const Scene& scene, const Spectrum& lattice, const Repulsion& law, int points,
            double sound_speed) {
  const double stiffness = law.stiffness(largest_point_force(scene, points, sound_speed));
  return {lattice, moving_ends(scene) * stiffness * points, sound_speed, std::nullopt,
          Motion::spacing(points)};
}

double contact_rate(const Scene& scene, const Rates& rates, IntegratorKind integrator,
                    double step) {
  constexpr double kOfEstimate = 0.65;
  const double margin = Motion::wall_margin(solves_for_bonds(integrator));
  if (rates.met) return margin * *rates.met;
  const double approach =
      scene.kind == SceneKind::kCollision ? scene.impact.approach_velocity() : 0.0;
  const double way = scene.wall.a * approach * step;
  return kOfEstimate * margin * rates.wall * std::exp(way / 2.0 + way * way / 8.0);
}

double rate_of_gain(const Scene& scene, const Rates& rates) {
  const double elongation = rates.spacing * scene.impact.velocity / std::sqrt(scene.material.k_a);
  return rates.lattice.omega_squared * 3.0 * scene.material.k_b * elongation * elongation /
         scene.material.k_a;
}

double points_at(double spacing) { return M_PI / (spacing * spacing); }

}  // namespace impact
