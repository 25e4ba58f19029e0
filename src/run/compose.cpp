#include "run/compose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lattice/input_error.hpp"
#include "measure/flags.hpp"
#include "run/elastic_wall_body.hpp"
#include "run/expected_time.hpp"
#include "run/forecast.hpp"
#include "run/make_integrator.hpp"
#include "run/row_of_disks.hpp"
#include "run/slow_impact.hpp"
#include "run/spinning_shape.hpp"
#include "scene/parameter_table.hpp"

namespace impact {
namespace {

/// Of a static solution, an iteration of which counts as a step.
constexpr Resolution kNoMotion{IntegratorKind::kNewton, 1.0, 0.0};

constexpr int kMostToSimulate = 1000000;

/// The ends are drawn apart by grips that hold x and let y go, so that they do not hinder the
/// lateral contraction.
Composition compose_stretch(const Scene& scene, std::shared_ptr<const Bodies> bodies) {
  const Lattice& lattice = bodies->disk();
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
  const PointArray& reference = bodies.disk().points;
  const double spin = scene.kind == SceneKind::kCollision ? scene.impact.spin : 0.0;
  return spin == 0.0 ? reference : spinning_shape(scene, bodies);
}

/// Moves the disk to where its lowest point is at this height.
void raise(double lowest, PointArray& disk) { disk.col(1) += lowest - disk.col(1).minCoeff(); }

/// Moves the disk so far to the side that it will touch another disk at its top: as high above it
/// as one point would hold the energy of the motion along y.
void move_aside(const Scene& scene, const Bodies& bodies, const Repulsion& law, double lowest,
                PointArray& disk) {
  const double energy = impact_energy(scene, reduced_mass(scene, bodies));
  disk.col(0) -= scene.impact.tangent() * (lowest - law.gap_of_energy(energy));
}

/// A gap between disks from which on all that their points hold is a negligible energy.
double negligible_gap(const Scene& scene, const Bodies& bodies, const Repulsion& law) {
  const double negligible = reduced_mass(scene, bodies) * negligible_wall_energy(scene);
  return law.gap_of_energy(negligible / static_cast<double>(bodies.bonds.points()));
}

/// A height from which on what the disk meets holds less than a negligible energy.
double negligible_height(const Scene& scene, const Bodies& bodies, const PotentialWall& wall,
                         const PointArray& disk) {
  if (scene.hits_disk()) return negligible_gap(scene, bodies, wall);
  return wall.height_of_energy(disk, negligible_wall_energy(scene));
}

/// The disk as it comes down, at any height.
PointArray disk_at_start(const Scene& scene, const Bodies& bodies) {
  PointArray disk = shape_at_start(scene, bodies);
  if (scene.hits_disk() && scene.disk.orientation == Orientation::kBalanced) {
    disk.col(0) -= disk.col(0).mean();
  }
  return disk;
}

/// Between the disks of a row, R.
double gap_in_row(const Scene& scene, const Bodies& bodies, const Repulsion& law) {
  return scene.hits_disk() ? negligible_gap(scene, bodies, law) : 0.0;
}

/// A row with a negligible gap from disk to disk, and the wall as it lies.
void place_others(const Bodies& bodies, double gap, PointArray& position) {
  Eigen::Index row = bodies.disk().points.rows();
  for (std::size_t k = 1; k < bodies.all.size(); ++k) {
    const PointArray& points = bodies.all[k].lattice.points;
    auto placed = position.middleRows(row, points.rows());
    placed = points;
    placed.col(1) -= static_cast<double>(k - 1) * gap;
    row += points.rows();
  }
}

/// The disk above what it meets, which has its surface at y = 0. A wall is at rest, disks move as
/// seen from their common centre of mass.
State initial_state(const Scene& scene, const Bodies& bodies, const PotentialWall& wall) {
  PointArray disk = disk_at_start(scene, bodies);
  const Eigen::Index points = disk.rows();
  const Eigen::Index other_points = bodies.other_points();
  State state;
  state.velocity = PointArray::Zero(points + other_points, 2);
  if (scene.kind == SceneKind::kContact) {
    raise(wall.gap_of_force(scene.load.p), disk);
  } else {
    const double part = reduced_mass(scene, bodies);
    const Eigen::Array2d velocity{part * scene.impact.tangential_velocity(),
                                  -part * scene.impact.normal_velocity()};
    const Eigen::Array2d centre = disk.colwise().mean();
    state.velocity.col(0).head(points) =
        velocity.x() - scene.impact.spin * (disk.col(1) - centre.y());
    state.velocity.col(1).head(points) =
        velocity.y() + scene.impact.spin * (disk.col(0) - centre.x());
    if (scene.hits_disk()) {
      const double ratio = static_cast<double>(points) / static_cast<double>(other_points);
      state.velocity.bottomRows(other_points).rowwise() -= ratio * velocity.transpose();
    }
    const double lowest = gap_at_start(scene, negligible_height(scene, bodies, wall, disk));
    raise(lowest, disk);
    if (scene.hits_disk()) move_aside(scene, bodies, wall, lowest, disk);
  }
  state.position.resize(points + other_points, 2);
  state.position.topRows(points) = disk;
  place_others(bodies, gap_in_row(scene, bodies, wall), state.position);
  return state;
}

void add_others(const Scene& scene, const Bodies& bodies, ForceField& field) {
  Eigen::Index row = bodies.disk().points.rows();
  for (std::size_t k = 1; k < bodies.all.size(); ++k) {
    const Eigen::Index points = bodies.all[k].lattice.points.rows();
    field.others.push_back({row, points, scene.hits_disk()});
    row += points;
  }
}

void add_disk_contacts(const Scene& scene, const Bodies& bodies, const Repulsion& law,
                       const PointArray& position, ForceField& field) {
  std::vector<std::vector<std::int32_t>> outlines;
  for (std::size_t k = 0; k < bodies.all.size(); ++k) {
    outlines.push_back(closed_outline(bodies.all[k].lattice.points, field.body(k).first));
  }
  field.disk_contacts.emplace(law, scene.wall.threshold, outlines, position);
}

void add_terms(const Scene& scene, const Bodies& bodies, const PotentialWall& wall,
               const PointArray& position, ForceField& field) {
  add_others(scene, bodies, field);
  if (scene.has_elastic_wall()) {
    add_elastic_wall(scene, bodies.all.back(), wall, position, field);
  } else if (scene.hits_disk()) {
    add_disk_contacts(scene, bodies, wall, position, field);
  } else {
    field.wall = wall;
  }
  if (scene.gravity != 0.0 && scene.kind == SceneKind::kCollision) {
    field.gravity.emplace(scene.gravity, bodies.disk().points.rows());
  }
  if (scene.kind != SceneKind::kContact) return;
  field.load.emplace(scene.load.p, bodies.disk().points.rows());
  if (scene.load.hold_rotation) field.hold.emplace(bodies.disk().points);
}

Composition compose_on_wall(const Scene& scene, std::shared_ptr<const Bodies> bodies) {
  const Eigen::Index points = bodies->disk().points.rows();
  const double mass = 1.0 / static_cast<double>(points);
  const PotentialWall wall = repulsion(scene, points);

  State initial = initial_state(scene, *bodies, wall);
  const double row_gap = gap_in_row(scene, *bodies, wall);
  ForceField field{bonds_of(scene, *bodies, mass), mass};
  if (!scene.has_passing_contacts()) {
    field.unstrained = std::shared_ptr<const PointArray>(bodies, &bodies->disk().points);
  }
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
  const bool is_floppy = has_flag(bodies->flags, Flag::kFloppy);
  const bool is_slow = may_be_reduced(scene, points) && !is_floppy;
  Rates rates_of_scene = rates(scene, spectrum, wall, static_cast<int>(points), sound_speed);
  rates_of_scene.time = expected_time(scene, points, gap, row_gap);
  rates_of_scene.modal = !is_floppy;
  return {std::move(bodies),
          std::move(field),
          std::move(initial),
          rates_of_scene,
          is_slow ? reduced_resolution(scene) : first_resolution(scene, rates_of_scene),
          rates_of_scene.time};
}

}  // namespace

State start_of(const Composition& composition, const Resolution& resolution) {
  State start = composition.initial;
  const Eigen::Index points = composition.bodies->disk().points.rows();
  start.position.col(1).head(points) += resolution.lift;
  if (composition.field.disk_contacts) {
    const auto velocity = start.velocity.topRows(points).colwise().mean();
    start.position.col(0).head(points) += velocity(0) / velocity(1) * resolution.lift;
  }
  return start;
}

void refuse_impossible(const Scene& scene) {
  const int points = scene.disk.recipe.points;
  if (points > kMostToSimulate && scene.disk.file.empty()) {
    throw bad_value("disk.points", std::to_string(points),
                    fmt::format("at most {}; to_lammps takes more", kMostToSimulate));
  }
  refuse_missing_integrator(scene);
  if (scene.has_recipes_only()) refuse_if_too_long(scene);
}

Composition compose(const Scene& scene, std::shared_ptr<const Bodies> bodies) {
  refuse_missing_integrator(scene);
  refuse_if_too_long(scene, bodies->disk().points.rows(), bodies->other_points());
  if (scene.kind == SceneKind::kContact && has_flag(bodies->flags, Flag::kFloppy)) {
    throw InputError(fmt::format(
        "disk.file: {}: the lattice is floppy, it can change its shape without a change of a bond: "
        "a contact has no state of rest",
        scene.disk.file));
  }
  const IntegratorKind integrator = scene.numerics.integrator;
  if (moves_less_than_all(integrator) && has_flag(bodies->flags, Flag::kFloppy)) {
    throw bad_value("numerics.integrator", traits_of(integrator).name,
                    "another one for a floppy lattice, which has no static compliance");
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
