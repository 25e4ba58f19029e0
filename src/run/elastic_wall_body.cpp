#include "run/elastic_wall_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "lattice/input_error.hpp"
#include "lattice/placement.hpp"
#include "run/file_lattice.hpp"

namespace impact {
namespace {

/// Elastic moduli of the triangular lattice, ρ c_L² = E/(1 − ν²) and ρ c_T² = E/(2 + 2ν) with
/// E = 2/√3 k_a and ν = 1/3, in units of k_a. Random lattices have moduli up to 14 % lower (uniform
/// placement); the dashpots, which go with the roots, reflect 1.4·10⁻³ of a wave's energy for that.
constexpr double kLongitudinalModulus = 1.2990381056766580;
constexpr double kTransverseModulus = 0.4330127018922193;

std::pair<double, double> width_and_height(const Scene::Wall& wall, Eigen::Index disk_points) {
  const double area = wall.points * M_PI / static_cast<double>(disk_points);
  if (wall.width && wall.height) return {*wall.width, *wall.height};
  if (wall.width) return {*wall.width, area / *wall.width};
  if (wall.height) return {area / *wall.height, *wall.height};
  const double height = std::sqrt(area / 2.0);
  return {2.0 * height, height};
}

Lattice placed_wall(const Scene& scene, Eigen::Index disk_points) {
  const auto [width, height] = width_and_height(scene.wall, disk_points);
  const PlacementRecipe recipe{scene.wall.points, scene.disk.recipe.placement, true};
  try {
    return triangulated_lattice(
        place_in_rectangle(recipe, width, height, scene.seed ^ kSeedOfOtherBody));
  } catch (const InputError& error) {
    throw InputError(fmt::format("wall.points: {}", error.what()));
  }
}

void move_into_place(Lattice& lattice) {
  const double left = lattice.points.col(0).minCoeff();
  const double right = lattice.points.col(0).maxCoeff();
  lattice.points.col(0) -= 0.5 * (left + right);
  lattice.points.col(1) -= lattice.points.col(1).maxCoeff();
}

std::vector<std::int32_t> boundary_points(const RectangleSides& sides, std::int32_t first_row) {
  std::vector<std::int32_t> points;
  for (const auto* side : {&sides.left, &sides.right, &sides.bottom}) {
    for (const std::int32_t point : *side) points.push_back(point + first_row);
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// Collects the dashpots of one side after another.
class DashpotBuilder {
 public:
  DashpotBuilder(const Lattice& wall, double point_mass, double k_a) : points_(wall.points) {
    const Eigen::Array2d size =
        (points_.colwise().maxCoeff() - points_.colwise().minCoeff()).transpose();
    const double density = point_mass * static_cast<double>(points_.rows()) / size.prod();
    across_ = std::sqrt(density * kLongitudinalModulus * k_a);
    along_ = std::sqrt(density * kTransverseModulus * k_a);
  }

  /// A side whose normal is the axis `normal` (0: x, 1: y).
  void add_side(const std::vector<std::int32_t>& side, int normal) {
    const int along = 1 - normal;
    for (std::size_t k = 0; k < side.size(); ++k) {
      const double begin = points_(side[k > 0 ? k - 1 : k], along);
      const double end = points_(side[k + 1 < side.size() ? k + 1 : k], along);
      const double tributary_length = 0.5 * (end - begin);
      Eigen::Array2d& coefficient =
          coefficients_.try_emplace(side[k], Eigen::Array2d::Zero()).first->second;
      coefficient(normal) += across_ * tributary_length;
      coefficient(along) += along_ * tributary_length;
    }
  }

  ViscousBoundary boundary(std::int32_t first_row) const {
    std::vector<ViscousBoundary::Dashpot> dashpots;
    dashpots.reserve(coefficients_.size());
    for (const auto& entry : coefficients_) {
      dashpots.push_back({entry.first + first_row, entry.second});
    }
    return ViscousBoundary(std::move(dashpots));
  }

 private:
  const PointArray& points_;
  double across_;  ///< ρ c_L, M c/R²
  double along_;   ///< ρ c_T
  std::map<std::int32_t, Eigen::Array2d> coefficients_;
};

}  // namespace

ViscousBoundary viscous_boundary(const PlacedBody& wall, double point_mass, double k_a,
                                 std::int32_t first_row) {
  DashpotBuilder builder(wall.lattice, point_mass, k_a);
  builder.add_side(wall.sides.left, 0);
  builder.add_side(wall.sides.right, 0);
  builder.add_side(wall.sides.bottom, 1);
  return builder.boundary(first_row);
}

PlacedBody elastic_wall_body(const Scene& scene, Eigen::Index disk_points) {
  if (scene.wall.file.empty()) {
    Lattice lattice = placed_wall(scene, disk_points);
    move_into_place(lattice);
    RectangleSides sides = rectangle_sides(lattice);
    return {std::move(lattice), std::move(sides), {}};
  }
  try {
    auto [lattice, flags] = lattice_of_file(scene.wall.file);
    move_into_place(lattice);
    RectangleSides sides = rectangle_sides(lattice);
    return {std::move(lattice), std::move(sides), std::move(flags)};
  } catch (const InputError& error) {
    throw InputError(fmt::format("wall.file: {}", error.what()));
  }
}

void add_elastic_wall(const Scene& scene, const PlacedBody& wall, const Repulsion& law,
                      const PointArray& position, ForceField& field) {
  const auto first_row = static_cast<std::int32_t>(position.rows() - wall.lattice.points.rows());
  std::vector<std::int32_t> points(static_cast<std::size_t>(first_row));
  std::iota(points.begin(), points.end(), 0);
  std::vector<std::int32_t> surface = wall.sides.top;
  for (std::int32_t& point : surface) point += first_row;
  field.elastic_wall.emplace(law, scene.wall.threshold, scene.wall.gap, std::move(points),
                             std::move(surface), position);

  std::vector<std::int32_t> boundary = boundary_points(wall.sides, first_row);
  switch (scene.wall.boundary) {
    case Boundary::kReset:
      field.velocity_reset.emplace(std::move(boundary), scene.wall.reset_interval);
      break;
    case Boundary::kFixed:
      field.supports.emplace(boundary, boundary);
      break;
    case Boundary::kViscous:
      field.viscous_boundary =
          viscous_boundary(wall, field.point_mass, scene.wall_material().k_a, first_row);
      break;
  }
}

}  // namespace impact
