#include "run/expected_time.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/disk_contact.hpp"
#include "theory/quasi_static.hpp"

namespace impact {
namespace {

/// Flight, in R/c, before the wall's energy is no longer negligible. At high speeds it leaves
/// nothing of that energy at the start, so that even a disk which folds meets the wall in the same
/// way whatever the wanted error.
constexpr double kApproach = 0.5;

/// Rough time until the disk's bouncing on the wall has decayed to the wanted error. The disk is
/// the spring k_d = dP/dξ ≈ πE/(ln(4πER/P) − 2) of the 2D Hertz contact with Kelvin–Voigt damping
/// of the time constant η/k_a, in series with the wall's own undamped spring k_w = a P. So the
/// bouncing decays at the rate (η/k_a) k_d (k_w/(k_w + k_d))²/(2M), or k_a/η when overdamped.
double relaxation_time(const Scene& scene, Eigen::Index points) {
  const double time_constant =
      scene.material.eta / (static_cast<double>(points) * scene.material.k_a);
  const double pi_e = std::pow(estimated_sound_speed(scene.material.k_a), 2);
  const double disk = pi_e / std::max(1.0, std::log(4.0 * pi_e / scene.load.p) - 2.0);
  const double wall = scene.wall.a * scene.load.p;
  const double share = wall / (wall + disk);
  const double rate = std::min(0.5 * time_constant * disk * share * share, 1.0 / time_constant);
  return std::log(10.0 / scene.numerics.error) / rate;
}

double impact_time(const Scene& scene, double gap, double gap_in_row) {
  const double softer = std::min(scene.material.k_a, scene.wall_material().k_a);
  const double sound_speed = estimated_sound_speed(softer);
  const double v = scene.impact.normal_velocity();
  const double contact = contact_time_at_most(sound_speed, v);
  const double in_row =
      scene.hits_disk() ? (scene.wall.disks - 1) * (gap_in_row / v + contact) : 0.0;
  return 2.0 * std::max(0.0, gap) / v + contact + in_row;
}

}  // namespace

double estimated_sound_speed(double k_a) { return sound_speed(2.0 / std::sqrt(3.0) * k_a); }

PotentialWall repulsion(const Scene& scene, Eigen::Index points) {
  const double mass = 1.0 / static_cast<double>(points);
  const double part = scene.wall.kind == WallKind::kPotential ? 1.0 : 0.5;
  return {scene.wall.a, scene.wall.v0.value_or(part * scene.wall.a * mass)};
}

double moving_ends(const Scene& scene) {
  switch (scene.wall.kind) {
    case WallKind::kPotential:
      break;
    case WallKind::kLattice:
      return SurfaceContact::kMovingEnds;
    case WallKind::kDisk:
      return DiskContact::kMovingEnds;
  }
  return 1.0;
}

double impact_energy(const Scene& scene, double reduced_mass) {
  const double v = scene.impact.normal_velocity();
  return reduced_mass * 0.5 * v * v;
}

double negligible_wall_energy(const Scene& scene) {
  return negligible_fraction(scene) * impact_energy(scene, 1.0);
}

double contact_time_at_most(double sound_speed, double velocity) {
  const double fastest = 4.0 * sound_speed * std::exp(-1.0);
  return contact_time(sound_speed, std::min(velocity, fastest));
}

double negligible_fraction(const Scene& scene) { return 0.01 * scene.numerics.error; }

double remaining_fraction(const Scene& scene) { return scene.numerics.error / 4000.0; }

bool has_resets(const Scene& scene) {
  return scene.has_elastic_wall() && scene.wall.boundary == Boundary::kReset;
}

double on_whole_resets(const Scene& scene, double height) {
  if (!has_resets(scene)) return height;
  const double way = scene.impact.normal_velocity() * scene.wall.reset_interval;
  return way * std::ceil(height / way);
}

double gap_at_start(const Scene& scene, double negligible_height) {
  if (scene.impact.gap) return *scene.impact.gap;
  return on_whole_resets(scene, negligible_height + kApproach * scene.impact.normal_velocity());
}

double expected_time(const Scene& scene, Eigen::Index points, double gap, double gap_in_row) {
  return scene.kind == SceneKind::kCollision ? impact_time(scene, gap, gap_in_row)
                                             : relaxation_time(scene, points);
}

}  // namespace impact
