#include "lattice/triangulation.hpp"

#include <gtest/gtest.h>

#include "expect_input_error.hpp"
#include "lattice/placement.hpp"

namespace impact {
namespace {

TEST(DelaunayBonds, OfAKiteTakeTheShortDiagonal) {
  PointArray points(4, 2);
  points << 0, 0, 1, -0.2, 2, 0, 1, 0.2;
  const std::vector<Bond> expected{{0, 1}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  EXPECT_EQ(delaunay_bonds(points), expected);
}

/// Euler's formula: a triangulation of N points, H of them on the hull, has 3N − 3 − H edges.
TEST(DelaunayBonds, HaveEulersNumber) {
  const PointArray points = place_in_disk({}, 7);
  const std::size_t on_rim = 117;  // ⌊2π/√(π/1099)⌋, all on the circle and so on the hull
  EXPECT_EQ(delaunay_bonds(points).size(), 3U * 1099U - 3U - on_rim);
}

TEST(DelaunayBonds, AreTheSameEveryTime) {
  const PointArray points = place_in_disk({}, 7);
  EXPECT_EQ(delaunay_bonds(points), delaunay_bonds(points));
}

TEST(DelaunayBonds, NameThePointsThatCoincide) {
  PointArray points(5, 2);
  points << 0, 0, 1, 0, 0, 1, 1, 1, 1, 0;
  EXPECT_INPUT_ERROR(delaunay_bonds(points), "points 2 and 5 coincide, at (1, 0)");
}

}  // namespace
}  // namespace impact
