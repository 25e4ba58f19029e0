#include "run/second_disk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lattice/input_error.hpp"
#include "lattice/placement.hpp"
#include "run/balance.hpp"
#include "run/file_lattice.hpp"
#include "statics/tethers.hpp"

namespace impact {
namespace {

SecondBody as_placed(const Scene& scene, const Lattice& first) {
  if (scene.wall.mirrored) {
    PointArray points = first.points;
    points.col(1) *= -1.0;
    return {make_lattice(std::move(points), first.bonds)};
  }
  if (!scene.wall.file.empty()) {
    try {
      FileLattice file = lattice_of_file(scene.wall.file);
      return {std::move(file.lattice), {}, std::move(file.flags)};
    } catch (const InputError& error) {
      throw InputError(fmt::format("wall.file: {}", error.what()));
    }
  }
  PlacementRecipe recipe = scene.disk.recipe;
  recipe.points = *scene.second_disk_points(static_cast<double>(first.points.rows()));
  return {triangulated_lattice(scene.wall.radius *
                               place_in_disk(recipe, scene.seed ^ kSeedOfSecondBody))};
}

}  // namespace

SecondBody second_disk(const Scene& scene, const Lattice& first) {
  SecondBody disk = as_placed(scene, first);
  Lattice& lattice = disk.lattice;
  if (scene.disk.orientation == Orientation::kBalanced) {
    if (!scene.wall.mirrored) {
      lattice = balanced(std::move(lattice));
      lattice.points *= -1.0;
    }
    lattice.points.col(0) -= lattice.points.col(0).mean();
  }
  lattice.points.col(1) -= lattice.points.col(1).maxCoeff();
  return disk;
}

std::vector<std::int32_t> closed_outline(const PointArray& points, Eigen::Index first_row) {
  std::vector<std::int32_t> rows;
  for (const Eigen::Index corner : convex_hull(points)) {
    rows.push_back(static_cast<std::int32_t>(first_row + corner));
  }
  std::reverse(rows.begin(), rows.end());
  rows.push_back(rows.front());
  return rows;
}

void add_disk_contact(const Scene& scene, const Lattice& first, const SecondBody& second,
                      const Repulsion& law, const PointArray& position, ForceField& field) {
  field.disk_contact.emplace(law, scene.wall.threshold, closed_outline(first.points, 0),
                             closed_outline(second.lattice.points, first.points.rows()), position);
}

}  // namespace impact
