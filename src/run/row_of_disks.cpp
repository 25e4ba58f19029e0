#include "run/row_of_disks.hpp"

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

PlacedBody mirror_image(const Lattice& above) {
  PointArray points = above.points;
  points.col(1) *= -1.0;
  return {make_lattice(std::move(points), above.bonds)};
}

PlacedBody disk_of_file(const Scene& scene) {
  try {
    FileLattice file = lattice_of_file(scene.wall.file);
    return {std::move(file.lattice), {}, std::move(file.flags)};
  } catch (const InputError& error) {
    throw InputError(fmt::format("wall.file: {}", error.what()));
  }
}

PlacedBody as_placed(const Scene& scene, const Lattice& first, const Lattice& above,
                     std::uint64_t number) {
  if (scene.wall.mirrored) return mirror_image(above);
  if (!scene.wall.file.empty()) return disk_of_file(scene);
  PlacementRecipe recipe = scene.disk.recipe;
  recipe.points = *scene.points_of_row_disk(static_cast<double>(first.points.rows()));
  return {triangulated_lattice(scene.wall.radius *
                               place_in_disk(recipe, scene.seed ^ (number * kSeedOfOtherBody)))};
}

/// Turned so that its centre of mass lies below its top.
void balance(const Scene& scene, Lattice& lattice) {
  if (!scene.wall.mirrored) {
    lattice = balanced(std::move(lattice));
    lattice.points *= -1.0;
  }
  lattice.points.col(0) -= lattice.points.col(0).mean();
}

}  // namespace

std::vector<PlacedBody> row_of_disks(const Scene& scene, const Lattice& first) {
  std::vector<PlacedBody> row;
  double top = 0.0;
  for (int number = 1; number <= scene.wall.disks; ++number) {
    const Lattice& above = row.empty() ? first : row.back().lattice;
    PlacedBody disk = as_placed(scene, first, above, static_cast<std::uint64_t>(number));
    if (scene.disk.orientation == Orientation::kBalanced) balance(scene, disk.lattice);
    auto height = disk.lattice.points.col(1);
    height -= height.maxCoeff() - top;
    top = height.minCoeff();
    row.push_back(std::move(disk));
  }
  return row;
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

}  // namespace impact
