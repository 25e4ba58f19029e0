#include "run/compose.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "run/elastic_wall_body.hpp"

namespace impact {
namespace {

/// Flight, in R/c, before the wall's energy is no longer negligible. At high speeds it leaves
/// nothing of that energy at the start, so that even a disk which folds meets the wall in the same
/// way whatever the wanted error.
constexpr double kApproach = 0.5;

/// Of a static solution, an iteration of which counts as a step.
constexpr Resolution kNoMotion{IntegratorKind::kNewton, 1.0, 0.0};

/// E of the triangular lattice, 2/√3 k_a, and the density M/(πR²): close to what random lattices
/// have (physics: 1.04 … 1.1 k_a).
double estimated_sound_speed(double k_a) { return std::sqrt(2.0 / std::sqrt(3.0) * k_a * M_PI); }

/// Rough time until the disk's bouncing on the wall has decayed to the wanted error. The disk is
/// the spring k_d = dP/dξ ≈ πE/(ln(4πER/P) − 2) of the 2D Hertz contact with Kelvin–Voigt damping
/// of the time constant η/k_a, in series with the wall's own undamped spring k_w = a P. So the
/// bouncing decays at the rate (η/k_a) k_d (k_w/(k_w + k_d))²/(2M), or k_a/η when overdamped.
double relaxation_time(const Scene& scene, double sound_speed, Eigen::Index points) {
  const double time_constant =
      scene.material.eta / (static_cast<double>(points) * scene.material.k_a);
  const double pi_e = sound_speed * sound_speed;
  const double disk = pi_e / std::max(1.0, std::log(4.0 * pi_e / scene.load.p) - 2.0);
  const double wall = scene.wall.a * scene.load.p;
  const double share = wall / (wall + disk);
  const double rate = std::min(0.5 * time_constant * disk * share * share, 1.0 / time_constant);
  return std::log(10.0 / scene.numerics.error) / rate;
}

double impact_time(const Scene& scene, double sound_speed, double gap) {
  const double v = scene.impact.velocity;
  const double contact =
      M_PI / sound_speed * std::sqrt(std::max(1.0, std::log(4.0 * sound_speed / v)));
  return 2.0 * std::max(0.0, gap) / v + contact;
}

/// The ends are drawn apart by grips that hold x and let y go, so that they do not hinder the
/// lateral contraction.
Composition compose_stretch(const Scene& scene, std::shared_ptr<const Bodies> bodies) {
  const Lattice& lattice = bodies->disk;
  const double mass = 1.0 / scene.disk.recipe.points;
  const BondLaw law{scene.material.k_a, scene.material.k_b, 0.0};
  ForceField field{bodies->bonds.with(law), mass};
  const RectangleSides sides = rectangle_sides(lattice);
  std::vector<std::int32_t> ends = sides.left;
  ends.insert(ends.end(), sides.right.begin(), sides.right.end());
  field.supports.emplace(std::move(ends), std::vector<std::int32_t>{});

  State initial;
  initial.position = lattice.points;
  initial.position.col(0) *= 1.0 + scene.stretch.strain;
  initial.velocity = PointArray::Zero(lattice.points.rows(), 2);
  return {std::move(bodies),  std::move(field),
          std::move(initial), {{}, 0.0, estimated_sound_speed(law.k_a)},
          kNoMotion,          0.0};
}

/// Where velocities are reset, the disk reaches the height 0 at a reset, so that what it meets
/// there does not depend on where it starts.
double automatic_gap(const Scene& scene, const PointArray& reference, const PotentialWall& wall) {
  const double v = scene.impact.velocity;
  const double gap =
      wall.height_of_energy(reference, negligible_wall_energy(scene)) + kApproach * v;
  return on_whole_resets(scene, gap);
}

/// The disk above the wall, which is at rest with its surface at y = 0.
State initial_state(const Scene& scene, const Bodies& bodies, const PotentialWall& wall) {
  const PointArray& reference = bodies.disk.points;
  const Eigen::Index points = reference.rows();
  const Eigen::Index wall_points = bodies.wall ? bodies.wall->lattice.points.rows() : 0;
  State state;
  state.position.resize(points + wall_points, 2);
  state.position.topRows(points) = reference;
  if (bodies.wall) state.position.bottomRows(wall_points) = bodies.wall->lattice.points;
  state.velocity = PointArray::Zero(state.position.rows(), 2);
  double lowest = 0.0;
  if (scene.kind == SceneKind::kContact) {
    lowest = wall.gap_of_force(scene.load.p);
  } else {
    lowest = scene.impact.gap ? *scene.impact.gap : automatic_gap(scene, reference, wall);
    state.velocity.col(1).head(points) = -scene.impact.velocity;
  }
  state.position.col(1).head(points) += lowest - reference.col(1).minCoeff();
  return state;
}

double expected_time(const Scene& scene, double sound_speed, Eigen::Index points, double gap) {
  if (scene.kind == SceneKind::kCollision) return impact_time(scene, sound_speed, gap);
  return relaxation_time(scene, sound_speed, points);
}

void add_terms(const Scene& scene, const Bodies& bodies, const PotentialWall& wall,
               const PointArray& position, ForceField& field) {
  if (bodies.wall) {
    add_elastic_wall(scene, *bodies.wall, wall, position, field);
  } else {
    field.wall = wall;
  }
  if (scene.kind != SceneKind::kContact) return;
  field.load.emplace(scene.load.p);
  if (scene.load.hold_rotation) field.hold.emplace(bodies.disk.points);
}

Composition compose_on_wall(const Scene& scene, std::shared_ptr<const Bodies> bodies) {
  const Eigen::Index points = bodies->disk.points.rows();
  const double mass = 1.0 / static_cast<double>(points);
  const double eta = scene.is_static() ? 0.0 : scene.material.eta * mass;
  const BondLaw law{scene.material.k_a, scene.material.k_b, eta};
  const double part = scene.wall.kind == WallKind::kLattice ? 0.5 : 1.0;
  const PotentialWall wall(scene.wall.a, scene.wall.v0.value_or(part * scene.wall.a * mass));

  State initial = initial_state(scene, *bodies, wall);
  ForceField field{bodies->bonds.with(law), mass};
  add_terms(scene, *bodies, wall, initial.position, field);
  const double sound_speed = estimated_sound_speed(law.k_a);
  if (scene.is_static()) {
    return {std::move(bodies),      std::move(field), std::move(initial),
            {{}, 0.0, sound_speed}, kNoMotion,        0.0};
  }
  Spectrum spectrum = spectrum_of(*bodies, law, mass);
  if (field.viscous_boundary) {
    spectrum.gamma += field.viscous_boundary->largest_coefficient() / mass;
  }

  const double gap = initial.position.col(1).head(points).minCoeff();
  const Rates rates_of_scene = rates(scene, spectrum, wall, static_cast<int>(points), sound_speed);
  return {std::move(bodies),
          std::move(field),
          std::move(initial),
          rates_of_scene,
          first_resolution(scene, rates_of_scene),
          expected_time(scene, sound_speed, points, gap)};
}

}  // namespace

double negligible_wall_energy(const Scene& scene) {
  return negligible_fraction(scene) * 0.5 * scene.impact.velocity * scene.impact.velocity;
}

double negligible_fraction(const Scene& scene) { return 0.01 * scene.numerics.error; }

State start_of(const Composition& composition, const Resolution& resolution) {
  State start = composition.initial;
  start.position.col(1).head(composition.bodies->disk.points.rows()) += resolution.lift;
  return start;
}

double on_whole_resets(const Scene& scene, double height) {
  if (scene.wall.kind != WallKind::kLattice || scene.wall.boundary != Boundary::kReset) {
    return height;
  }
  const double way = scene.impact.velocity * scene.wall.reset_interval;
  return way * std::ceil(height / way);
}

Composition compose(const Scene& scene, std::shared_ptr<const Bodies> bodies) {
  return scene.kind == SceneKind::kStretch ? compose_stretch(scene, std::move(bodies))
                                           : compose_on_wall(scene, std::move(bodies));
}

Composition compose(const Scene& scene) { return compose(scene, make_bodies(scene)); }

std::shared_ptr<const Composition> compose_shared(const Scene& scene) {
  return std::make_shared<const Composition>(compose(scene));
}

}  // namespace impact
