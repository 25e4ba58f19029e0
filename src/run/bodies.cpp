#include "run/bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lattice/input_error.hpp"
#include "lattice/placement.hpp"
#include "mechanics/body.hpp"
#include "mechanics/motion.hpp"
#include "run/balance.hpp"
#include "run/elastic_wall_body.hpp"
#include "run/file_lattice.hpp"
#include "run/row_of_disks.hpp"

namespace impact {
namespace {

/// Distance of the farthest point from the mean of all.
double radius_of(const Lattice& lattice) {
  return std::sqrt((lattice.points.rowwise() - lattice.points.colwise().mean())
                       .square()
                       .rowwise()
                       .sum()
                       .maxCoeff());
}

/// @throw InputError for a radius that is off by more than a fifth, if it is not to be scaled.
Lattice scaled(Lattice lattice, FileScale scale) {
  constexpr double kMostDeviation = 0.2;
  const double radius = radius_of(lattice);
  if (scale == FileScale::kRadius) {
    return make_lattice(lattice.points / radius, std::move(lattice.bonds));
  }
  if (std::abs(radius - 1.0) > kMostDeviation) {
    throw InputError(fmt::format(
        "the radius is {:.4g}, allowed: 0.8 … 1.2, or disk.scale: radius, which makes it 1",
        radius));
  }
  return lattice;
}

FileLattice disk_as_placed(const Scene& scene) {
  if (scene.disk.file.empty()) {
    return {triangulated_lattice(place_in_disk(scene.disk.recipe, scene.seed)), {}};
  }
  try {
    FileLattice file = lattice_of_file(scene.disk.file);
    file.lattice = scaled(std::move(file.lattice), scene.disk.scale);
    return file;
  } catch (const InputError& error) {
    throw InputError(fmt::format("disk.file: {}", error.what()));
  }
}

FileLattice disk_lattice(const Scene& scene) {
  FileLattice disk = disk_as_placed(scene);
  if (scene.disk.orientation == Orientation::kBalanced) {
    disk.lattice = balanced(std::move(disk.lattice));
  }
  return disk;
}

/// The rectangle of a stretch scene, with the disk's number density.
Lattice stretched_rectangle(const Scene& scene) {
  constexpr double kMostPoints = 1e6;
  const double area = scene.stretch.width * scene.stretch.height;
  const double points = std::round(scene.disk.recipe.points * area / M_PI);
  if (points > kMostPoints) {
    throw InputError(
        fmt::format("stretch: a {} by {} R rectangle with the disk's number density has {:.3g} "
                    "points, allowed: "
                    "at most {}",
                    scene.stretch.width, scene.stretch.height, points, kMostPoints));
  }
  const PlacementRecipe recipe{static_cast<int>(points), scene.disk.recipe.placement, true};
  try {
    return triangulated_lattice(
        place_in_rectangle(recipe, scene.stretch.width, scene.stretch.height, scene.seed));
  } catch (const InputError& error) {
    throw InputError(fmt::format("stretch: {}", error.what()));
  }
}

/// Nothing is damped where nothing moves.
BondLaw law_of(const Scene& scene, const Scene::Material& material, double point_mass) {
  return {material.k_a, material.k_b, scene.is_static() ? 0.0 : material.eta * point_mass};
}

/// What the disk meets.
std::vector<PlacedBody> others(const Scene& scene, const Lattice& disk) {
  if (scene.has_elastic_wall()) return {elastic_wall_body(scene, disk.points.rows())};
  if (scene.hits_disk()) return row_of_disks(scene, disk);
  return {};
}

void add_flags(const std::vector<std::string>& flags, std::vector<std::string>& all) {
  for (const std::string& flag : flags) {
    if (std::find(all.begin(), all.end(), flag) == all.end()) all.push_back(flag);
  }
}

/// Of the bodies from one on, one after another.
Lattice joined_from(std::size_t first, const std::vector<BodyOfScene>& bodies) {
  Lattice all = bodies[first].lattice;
  for (std::size_t k = first + 1; k < bodies.size(); ++k) all = joined(all, bodies[k].lattice);
  return all;
}

/// Of the bodies, one after another.
std::vector<std::int32_t> outer_points(const std::vector<BodyOfScene>& bodies) {
  const double depth =
      Motion::kDepthOfOuterPoints * Motion::spacing(bodies.front().lattice.points.rows());
  std::vector<std::int32_t> points;
  std::int32_t first = 0;
  for (const BodyOfScene& body : bodies) {
    for (const std::int32_t point : body.triangles.outer_points(body.lattice, depth)) {
      points.push_back(first + point);
    }
    first += static_cast<std::int32_t>(body.lattice.points.rows());
  }
  return points;
}

Spectrum unit_spectrum(const std::vector<BodyOfScene>& bodies, const Lattice& joined, bool damped) {
  return lattice_spectrum(joined, {1.0, 0.0, damped ? 1.0 : 0.0}, 1.0, outer_points(bodies));
}

}  // namespace

Eigen::Index Bodies::other_points() const { return bonds.points() - disk().points.rows(); }

Lattice Bodies::joined() const { return joined_from(0, all); }

std::shared_ptr<const Bodies> make_bodies(const Scene& scene) {
  FileLattice first = scene.kind == SceneKind::kStretch
                          ? FileLattice{stretched_rectangle(scene), {}}
                          : disk_lattice(scene);
  std::vector<PlacedBody> placed;
  placed.push_back({std::move(first.lattice), {}, std::move(first.flags)});
  for (PlacedBody& other : others(scene, placed.front().lattice)) {
    placed.push_back(std::move(other));
  }
  const bool flies = scene.kind == SceneKind::kCollision && !scene.is_static();
  std::vector<BodyOfScene> all;
  std::vector<std::string> flags;
  for (PlacedBody& body : placed) {
    add_flags(body.flags, flags);
    Triangles triangles(body.lattice);
    const Flexibility of_body = flies ? flexibility(body.lattice) : Flexibility{};
    all.push_back({std::move(body), std::move(triangles), of_body});
  }
  std::optional<Lattice> several;
  if (all.size() > 1) several = joined_from(0, all);
  const Lattice& lattice = several ? *several : all.front().lattice;
  std::optional<Spectrum> spectrum;
  if (!scene.is_static()) spectrum = unit_spectrum(all, lattice, scene.material.eta != 0.0);
  BondForces bonds(lattice, BondLaw{});
  return std::make_shared<const Bodies>(
      Bodies{std::move(all), std::move(bonds), spectrum, std::move(flags)});
}

std::string key_of_bodies(const Scene& scene) {
  const PlacementRecipe& recipe = scene.disk.recipe;
  std::string key =
      fmt::format("{} {} {} {} {} {} {}", scene.seed, recipe.points,
                  static_cast<int>(recipe.placement), recipe.rim, scene.disk.file,
                  static_cast<int>(scene.disk.scale), static_cast<int>(scene.disk.orientation));
  if (scene.kind == SceneKind::kStretch) {
    key += fmt::format("\nstretch {} {}", scene.stretch.width, scene.stretch.height);
  }
  if (scene.has_elastic_wall()) {
    const Scene::Wall& wall = scene.wall;
    key += fmt::format("\nwall {} {} {} {}", wall.points, wall.width.value_or(0.0),
                       wall.height.value_or(0.0), wall.file);
  }
  if (scene.hits_disk()) {
    key += fmt::format("\ndisks {} {} {} {}", scene.wall.disks, scene.wall.radius,
                       scene.wall.mirrored, scene.wall.file);
  }
  return key;
}

BondForces bonds_of(const Scene& scene, const Bodies& bodies, double point_mass) {
  const BondLaw of_disk = law_of(scene, scene.material, point_mass);
  if (!scene.has_own_wall_material()) return bodies.bonds.with(of_disk);
  const BondLaw of_wall = law_of(scene, scene.wall_material(), point_mass);
  return BondForces::of_two_laws(BondForces(bodies.disk(), of_disk),
                                 BondForces(joined_from(1, bodies.all), of_wall));
}

double reduced_mass(const Scene& scene, const Bodies& bodies) {
  if (!scene.hits_disk()) return 1.0;
  return reduced_mass(static_cast<double>(bodies.other_points()) /
                      static_cast<double>(bodies.disk().points.rows()));
}

Spectrum spectrum_of(const Scene& scene, const Bodies& bodies, double point_mass) {
  const BondLaw law = law_of(scene, scene.material, point_mass);
  if (scene.has_own_wall_material()) {
    const Spectrum disk = lattice_spectrum(bodies.disk(), law, point_mass);
    const Spectrum wall = lattice_spectrum(
        joined_from(1, bodies.all), law_of(scene, scene.wall_material(), point_mass), point_mass);
    return {std::max(disk.omega_squared, wall.omega_squared), std::max(disk.gamma, wall.gamma),
            0.0};
  }
  Spectrum unit;
  if (bodies.spectrum && (law.eta == 0.0 || bodies.spectrum->gamma > 0.0)) {
    unit = *bodies.spectrum;
  } else {
    unit = unit_spectrum(bodies.all, bodies.joined(), law.eta != 0.0);
  }
  return {law.k_a / point_mass * unit.omega_squared, law.eta / point_mass * unit.gamma,
          law.k_a / point_mass * unit.stiffened};
}

}  // namespace impact
