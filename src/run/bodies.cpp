#include "run/bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lattice/input_error.hpp"
#include "lattice/placement.hpp"
#include "mechanics/body.hpp"
#include "run/balance.hpp"
#include "run/elastic_wall_body.hpp"
#include "run/file_lattice.hpp"
#include "run/second_disk.hpp"

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

std::optional<SecondBody> second_body(const Scene& scene, const Lattice& disk) {
  if (scene.has_elastic_wall()) return elastic_wall_body(scene, disk.points.rows());
  if (scene.hits_disk()) return second_disk(scene, disk);
  return std::nullopt;
}

Spectrum unit_spectrum(const Lattice& lattice, bool damped) {
  return lattice_spectrum(lattice, {1.0, 0.0, damped ? 1.0 : 0.0}, 1.0);
}

}  // namespace

std::shared_ptr<const Bodies> make_bodies(const Scene& scene) {
  auto [disk, flags] = scene.kind == SceneKind::kStretch
                           ? FileLattice{stretched_rectangle(scene), {}}
                           : disk_lattice(scene);
  const std::optional<SecondBody> second = second_body(scene, disk);
  if (second) {
    for (const std::string& flag : second->flags) {
      if (std::find(flags.begin(), flags.end(), flag) == flags.end()) flags.push_back(flag);
    }
  }
  const Lattice all = second ? joined(disk, second->lattice) : disk;
  Triangles triangles(disk);
  std::optional<Triangles> second_triangles;
  if (second) second_triangles.emplace(second->lattice);
  std::optional<Spectrum> spectrum;
  if (!scene.is_static()) spectrum = unit_spectrum(all, scene.material.eta != 0.0);
  const bool flies = scene.kind == SceneKind::kCollision && !scene.is_static();
  const Flexibility of_disk = flies ? flexibility(disk) : Flexibility{};
  const Flexibility of_second = flies && second ? flexibility(second->lattice) : Flexibility{};
  return std::make_shared<const Bodies>(
      Bodies{std::move(disk), second, std::move(triangles), std::move(second_triangles),
             BondForces(all, BondLaw{}), spectrum, of_disk, of_second, std::move(flags)});
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
    key += fmt::format("\ndisk {} {} {}", scene.wall.radius, scene.wall.mirrored, scene.wall.file);
  }
  return key;
}

BondForces bonds_of(const Scene& scene, const Bodies& bodies, double point_mass) {
  const BondLaw of_disk = law_of(scene, scene.material, point_mass);
  if (!scene.has_own_wall_material()) return bodies.bonds.with(of_disk);
  const BondLaw of_wall = law_of(scene, scene.wall_material(), point_mass);
  return BondForces::of_two_bodies(BondForces(bodies.disk, of_disk),
                                   BondForces(bodies.second->lattice, of_wall));
}

double second_mass(const Bodies& bodies) {
  return static_cast<double>(bodies.second->lattice.points.rows()) /
         static_cast<double>(bodies.disk.points.rows());
}

double reduced_mass(const Scene& scene, const Bodies& bodies) {
  return scene.hits_disk() ? reduced_mass(second_mass(bodies)) : 1.0;
}

Spectrum spectrum_of(const Scene& scene, const Bodies& bodies, double point_mass) {
  const BondLaw law = law_of(scene, scene.material, point_mass);
  if (scene.has_own_wall_material()) {
    const Spectrum disk = lattice_spectrum(bodies.disk, law, point_mass);
    const Spectrum wall = lattice_spectrum(
        bodies.second->lattice, law_of(scene, scene.wall_material(), point_mass), point_mass);
    return {std::max(disk.omega_squared, wall.omega_squared), std::max(disk.gamma, wall.gamma)};
  }
  Spectrum unit;
  if (bodies.spectrum && (law.eta == 0.0 || bodies.spectrum->gamma > 0.0)) {
    unit = *bodies.spectrum;
  } else {
    unit = unit_spectrum(bodies.second ? joined(bodies.disk, bodies.second->lattice) : bodies.disk,
                         law.eta != 0.0);
  }
  return {law.k_a / point_mass * unit.omega_squared, law.eta / point_mass * unit.gamma};
}

}  // namespace impact
