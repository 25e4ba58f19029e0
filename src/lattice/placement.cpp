#include "lattice/placement.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace impact {
namespace {

constexpr double kBlueNoiseSpacing = 0.6;  // in units of s

/// Knows whether a point keeps its distance from all points added before: a grid of cells so small
/// (side = distance/√2) that each holds one point at most.
class SpacingGrid {
 public:
  explicit SpacingGrid(double distance)
      : distance_(distance),
        cell_(distance / std::sqrt(2.0)),
        side_(static_cast<int>(std::ceil(2.0 / cell_)) + 1 + 2 * kReach),
        occupant_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), kEmpty) {}

  bool is_free(const PointArray& points, double x, double y) const {
    const int column = index(x);
    const int row = index(y);
    for (int j = row - kReach; j <= row + kReach; ++j) {
      for (int i = column - kReach; i <= column + kReach; ++i) {
        const std::int32_t other = occupant_[at(i, j)];
        if (other == kEmpty) continue;
        if (std::hypot(points(other, 0) - x, points(other, 1) - y) < distance_) return false;
      }
    }
    return true;
  }

  void add(const PointArray& points, std::int32_t point) {
    occupant_[at(index(points(point, 0)), index(points(point, 1)))] = point;
  }

 private:
  static constexpr int kReach = 2;
  static constexpr std::int32_t kEmpty = -1;

  int index(double coordinate) const {
    return static_cast<int>((coordinate + 1.0) / cell_) + kReach;
  }
  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) +
           static_cast<std::size_t>(column);
  }

  double distance_;
  double cell_;
  int side_;
  std::vector<std::int32_t> occupant_;
};

class UniformInDisk {
 public:
  Eigen::Array<double, 1, 2> operator()(std::mt19937_64& random) {
    const double radius = std::sqrt(unit_(random));
    const double angle = 2.0 * M_PI * unit_(random);
    return {radius * std::cos(angle), radius * std::sin(angle)};
  }

 private:
  std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

std::int32_t place_rim(PointArray& points, double spacing, std::mt19937_64& random) {
  const auto on_rim = static_cast<std::int32_t>(
      std::min(static_cast<double>(points.rows()), std::floor(2.0 * M_PI / spacing)));
  const double turn = std::uniform_real_distribution<double>(0.0, 2.0 * M_PI)(random);
  for (std::int32_t k = 0; k < on_rim; ++k) {
    const double angle = turn + 2.0 * M_PI * k / on_rim;
    points.row(k) << std::cos(angle), std::sin(angle);
  }
  return on_rim;
}

}  // namespace

PointArray place_in_disk(const DiskRecipe& recipe, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  PointArray points(recipe.points, 2);
  const double spacing = std::sqrt(M_PI / recipe.points);
  const std::int32_t on_rim = recipe.rim ? place_rim(points, spacing, random) : 0;

  UniformInDisk draw;
  if (recipe.placement == Placement::kUniform) {
    for (Eigen::Index i = on_rim; i < points.rows(); ++i) points.row(i) = draw(random);
    return points;
  }

  // Discs of diameter 0.6 s around N points cover at most 0.28 of the area, well below the 0.547
  // at which random sequential placement jams, so the loop ends.
  SpacingGrid grid(kBlueNoiseSpacing * spacing);
  for (std::int32_t i = 0; i < on_rim; ++i) grid.add(points, i);
  for (std::int32_t i = on_rim; i < recipe.points; ++i) {
    do {
      points.row(i) = draw(random);
    } while (!grid.is_free(points, points(i, 0), points(i, 1)));
    grid.add(points, i);
  }
  return points;
}

}  // namespace impact
