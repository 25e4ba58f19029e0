#include "lattice/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "lattice/input_error.hpp"

namespace impact {
namespace {

constexpr double kBlueNoiseSpacing = 0.6;  // in units of s

/// Knows whether a point keeps its distance from all points added before: a grid of cells so small
/// (side = distance/√2) that each holds one point at most.
class SpacingGrid {
 public:
  SpacingGrid(double distance, double width, double height)
      : distance_(distance),
        cell_(distance / std::sqrt(2.0)),
        left_(-width / 2.0),
        bottom_(-height / 2.0),
        columns_(index(width) + 1),
        rows_(index(height) + 1),
        occupant_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kEmpty) {}

  bool is_free(const PointArray& points, double x, double y) const {
    const int column = index(x - left_);
    const int row = index(y - bottom_);
    for (int j = std::max(row - kReach, 0); j <= std::min(row + kReach, rows_ - 1); ++j) {
      for (int i = std::max(column - kReach, 0); i <= std::min(column + kReach, columns_ - 1);
           ++i) {
        const std::int32_t other = occupant_[at(i, j)];
        if (other == kEmpty) continue;
        const double dx = points(other, 0) - x;
        const double dy = points(other, 1) - y;
        if (dx * dx + dy * dy < distance_ * distance_) return false;
      }
    }
    return true;
  }

  void add(const PointArray& points, std::int32_t point) {
    occupant_[at(index(points(point, 0) - left_), index(points(point, 1) - bottom_))] = point;
  }

 private:
  static constexpr int kReach = 2;
  static constexpr std::int32_t kEmpty = -1;

  int index(double offset) const { return static_cast<int>(std::floor(offset / cell_)); }
  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  double distance_;
  double cell_;
  double left_;
  double bottom_;
  int columns_;
  int rows_;
  std::vector<std::int32_t> occupant_;
};

using Point = Eigen::Array<double, 1, 2>;

double unit_random(std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(0.0, 1.0)(random);
}

/// The disk of radius 1 about the origin.
class Disk {
 public:
  static constexpr double width() { return 2.0; }
  static constexpr double height() { return 2.0; }
  static constexpr double area() { return M_PI; }
  static std::vector<Point> images() { return {Point(0.0, 0.0)}; }

  static Point random_point(std::mt19937_64& random) {
    const double radius = std::sqrt(unit_random(random));
    const double angle = 2.0 * M_PI * unit_random(random);
    return {radius * std::cos(angle), radius * std::sin(angle)};
  }

  /// Returns the number of points on the rim.
  static std::int32_t place_rim(PointArray& points, double spacing, std::mt19937_64& random) {
    const auto on_rim = static_cast<std::int32_t>(
        std::min(static_cast<double>(points.rows()), std::floor(2.0 * M_PI / spacing)));
    const double turn = std::uniform_real_distribution<double>(0.0, 2.0 * M_PI)(random);
    for (std::int32_t k = 0; k < on_rim; ++k) {
      const double angle = turn + 2.0 * M_PI * k / on_rim;
      points.row(k) << std::cos(angle), std::sin(angle);
    }
    return on_rim;
  }
};

/// The rectangle about the origin.
class Rectangle {
 public:
  Rectangle(double width, double height) : width_(width), height_(height) {}
  double width() const { return width_; }
  double height() const { return height_; }
  double area() const { return width_ * height_; }
  static std::vector<Point> images() { return {Point(0.0, 0.0)}; }

  Point random_point(std::mt19937_64& random) const {
    const double x = width_ * (unit_random(random) - 0.5);
    const double y = height_ * (unit_random(random) - 0.5);
    return {x, y};
  }

  /// Returns the number of points on the rim.
  std::int32_t place_rim(PointArray& points, double spacing, std::mt19937_64&) const {
    const double along_width = std::max(1.0, std::round(width_ / spacing));
    const double along_height = std::max(1.0, std::round(height_ / spacing));
    const double on_rim = 2.0 * (along_width + along_height);
    if (on_rim > static_cast<double>(points.rows())) {
      throw InputError(fmt::format("the rim of a {} by {} R rectangle of {} points needs {} points",
                                   width_, height_, points.rows(), on_rim));
    }
    std::int32_t point = 0;
    for (int k = 0; k <= along_width; ++k) {
      const double x = width_ * (k / along_width - 0.5);
      points.row(point++) << x, -height_ / 2.0;
      points.row(point++) << x, height_ / 2.0;
    }
    for (int k = 1; k < along_height; ++k) {
      const double y = height_ * (k / along_height - 0.5);
      points.row(point++) << -width_ / 2.0, y;
      points.row(point++) << width_ / 2.0, y;
    }
    return point;
  }

 private:
  double width_;
  double height_;
};

class PeriodicRectangle : public Rectangle {
 public:
  using Rectangle::Rectangle;

  std::vector<Point> images() const {
    std::vector<Point> offsets;
    for (const double x : {-width(), 0.0, width()}) {
      for (const double y : {-height(), 0.0, height()}) offsets.emplace_back(x, y);
    }
    return offsets;
  }
};

bool is_free(const SpacingGrid& grid, const PointArray& points, const Point& point,
             const std::vector<Point>& images) {
  return std::all_of(images.begin(), images.end(), [&](const Point& image) {
    return grid.is_free(points, point.x() + image.x(), point.y() + image.y());
  });
}

template <class Region>
PointArray place(const PlacementRecipe& recipe, const Region& region, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  PointArray points(recipe.points, 2);
  const double spacing = std::sqrt(region.area() / recipe.points);
  const std::int32_t on_rim = recipe.rim ? region.place_rim(points, spacing, random) : 0;

  if (recipe.placement == Placement::kUniform) {
    for (Eigen::Index i = on_rim; i < points.rows(); ++i) {
      points.row(i) = region.random_point(random);
    }
    return points;
  }

  // Discs of diameter 0.6 s around N points cover at most 0.28 of the area, well below the 0.547
  // at which random sequential placement jams, so the loop ends.
  const std::vector<Point> images = region.images();
  SpacingGrid grid(kBlueNoiseSpacing * spacing, region.width(), region.height());
  for (std::int32_t i = 0; i < on_rim; ++i) grid.add(points, i);
  for (std::int32_t i = on_rim; i < recipe.points; ++i) {
    do {
      points.row(i) = region.random_point(random);
    } while (!is_free(grid, points, points.row(i), images));
    grid.add(points, i);
  }
  return points;
}

}  // namespace

PointArray place_in_disk(const PlacementRecipe& recipe, std::uint64_t seed) {
  return place(recipe, Disk(), seed);
}

PointArray place_in_rectangle(const PlacementRecipe& recipe, double width, double height,
                              std::uint64_t seed) {
  return place(recipe, Rectangle(width, height), seed);
}

PointArray place_in_periodic_rectangle(int points, Placement placement, double width, double height,
                                       std::uint64_t seed) {
  return place({points, placement, false}, PeriodicRectangle(width, height), seed);
}

}  // namespace impact
