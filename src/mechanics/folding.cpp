#include "mechanics/folding.hpp"

#include <algorithm>
#include <cmath>

namespace impact {
namespace {

/// Twice the area, positive where a, b, c run counter-clockwise.
double signed_area(const Eigen::Ref<const PointArray>& points, std::int32_t a, std::int32_t b,
                   std::int32_t c) {
  return (points(b, 0) - points(a, 0)) * (points(c, 1) - points(a, 1)) -
         (points(b, 1) - points(a, 1)) * (points(c, 0) - points(a, 0));
}

std::vector<std::vector<std::int32_t>> neighbours_by_angle(const Lattice& lattice) {
  std::vector<std::vector<std::int32_t>> neighbours(
      static_cast<std::size_t>(lattice.points.rows()));
  for (const Bond& bond : lattice.bonds) {
    neighbours[static_cast<std::size_t>(bond.first)].push_back(bond.second);
    neighbours[static_cast<std::size_t>(bond.second)].push_back(bond.first);
  }
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    const auto centre = lattice.points.row(static_cast<Eigen::Index>(i));
    const auto angle = [&](std::int32_t j) {
      return std::atan2(lattice.points(j, 1) - centre(1), lattice.points(j, 0) - centre(0));
    };
    std::sort(neighbours[i].begin(), neighbours[i].end(),
              [&](std::int32_t a, std::int32_t b) { return angle(a) < angle(b); });
  }
  return neighbours;
}

}  // namespace

Triangles::Triangles(const Lattice& lattice) {
  const auto neighbours = neighbours_by_angle(lattice);
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    const auto a = static_cast<std::int32_t>(i);
    for (std::size_t k = 0; k < neighbours[i].size(); ++k) {
      const std::int32_t b = neighbours[i][k];
      const std::int32_t c = neighbours[i][(k + 1) % neighbours[i].size()];
      if (a > b || a > c) continue;  // each triangle from its first corner
      const bool bonded = std::binary_search(lattice.bonds.begin(), lattice.bonds.end(),
                                             Bond{std::min(b, c), std::max(b, c)});
      if (bonded && signed_area(lattice.points, a, b, c) > 0.0) corners_.push_back({a, b, c});
    }
  }
}

std::size_t Triangles::turned_over(const Eigen::Ref<const PointArray>& position) const {
  return static_cast<std::size_t>(
      std::count_if(corners_.begin(), corners_.end(), [&](const auto& triangle) {
        return signed_area(position, triangle[0], triangle[1], triangle[2]) < 0.0;
      }));
}

}  // namespace impact
