#include "run/compose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "lattice/input_error.hpp"
#include "measure/flags.hpp"
#include "run/elastic_wall_body.hpp"
#include "run/expected_time.hpp"
#include "run/forecast.hpp"
#include "run/spinning_shape.hpp"

namespace impact {
namespace {

/// Of a static solution, an iteration of which counts as a step.
constexpr Resolution kNoMotion{IntegratorKind::kNewton, 1.0, 0.0};

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

/// The disk at the start of an impact: as it is, or stretched by its steady spin.
PointArray shape_at_start(const Scene& scene, const Bodies& bodies) {
  const PointArray& reference = bodies.disk.points;
  const double spin = scene.kind == SceneKind::kCollision ? scene.impact.spin : 0.0;
  return spin == 0.0 ? reference : spinning_shape(scene, bodies);
}

/// The disk above the wall, which is at rest with its surface at y = 0.
State initial_state(const Scene& scene, const Bodies& bodies, const PotentialWall& wall) {
  const PointArray reference = shape_at_start(scene, bodies);
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
    lowest = gap_at_start(scene, wall.height_of_energy(reference, negligible_wall_energy(scene)));
    const Eigen::Array2d centre = reference.colwise().mean();
    state.velocity.col(0).head(points) =
        scene.impact.tangential_velocity() - scene.impact.spin * (reference.col(1) - centre.y());
    state.velocity.col(1).head(points) =
        -scene.impact.normal_velocity() + scene.impact.spin * (reference.col(0) - centre.x());
  }
  state.position.col(1).head(points) += lowest - reference.col(1).minCoeff();
  return state;
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
  const PotentialWall wall = repulsion(scene, points);

  State initial = initial_state(scene, *bodies, wall);
  ForceField field{bonds_of(scene, *bodies, mass), mass};
  add_terms(scene, *bodies, wall, initial.position, field);
  const double sound_speed = estimated_sound_speed(scene.material.k_a);
  if (scene.is_static()) {
    return {std::move(bodies),      std::move(field), std::move(initial),
            {{}, 0.0, sound_speed}, kNoMotion,        0.0};
  }
  Spectrum spectrum = spectrum_of(scene, *bodies, mass);
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
          expected_time(scene, points, gap)};
}

}  // namespace

State start_of(const Composition& composition, const Resolution& resolution) {
  State start = composition.initial;
  start.position.col(1).head(composition.bodies->disk.points.rows()) += resolution.lift;
  return start;
}

void refuse_impossible(const Scene& scene) {
  refuse_missing_integrator(scene);
  if (scene.has_recipes_only()) refuse_if_too_long(scene);
}

Composition compose(const Scene& scene, std::shared_ptr<const Bodies> bodies) {
  refuse_missing_integrator(scene);
  refuse_if_too_long(scene, bodies->disk.points.rows(),
                     bodies->wall ? bodies->wall->lattice.points.rows() : 0);
  if (scene.kind == SceneKind::kContact && has_flag(bodies->flags, Flag::kFloppy)) {
    throw InputError(fmt::format(
        "disk.file: {}: the lattice is floppy, it can change its shape without a change of a bond: "
        "a contact has no state of rest",
        scene.disk.file));
  }
  return scene.kind == SceneKind::kStretch ? compose_stretch(scene, std::move(bodies))
                                           : compose_on_wall(scene, std::move(bodies));
}

Composition compose(const Scene& scene) {
  refuse_impossible(scene);
  return compose(scene, make_bodies(scene));
}

std::shared_ptr<const Composition> compose_shared(const Scene& scene) {
  return std::make_shared<const Composition>(compose(scene));
}

}  // namespace impact
