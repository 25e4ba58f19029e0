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

/// On a grid of 2ᵏ × 2ᵏ points the curve goes from neighbour to neighbour.
TEST(HilbertOrder, GoesFromNeighbourToNeighbour) {
  constexpr int kSide = 8;
  PointArray grid(kSide * kSide, 2);
  for (int i = 0; i < grid.rows(); ++i) grid.row(i) << i % kSide, i / kSide;
  const std::vector<std::int32_t> order = hilbert_order(grid);
  ASSERT_EQ(order.size(), 64U);
  for (std::size_t k = 1; k < order.size(); ++k) {
    EXPECT_EQ((grid.row(order[k]) - grid.row(order[k - 1])).abs().sum(), 1.0);
  }
}

TEST(DelaunayBonds, AreTheSameEveryTime) {
  const PointArray points = place_in_disk({}, 7);
  EXPECT_EQ(delaunay_bonds(points), delaunay_bonds(points));
}

TEST(DelaunayBonds, AreTheSameInAnyOrder) {
  const PointArray points = place_in_disk({}, 7);
  EXPECT_EQ(delaunay_bonds(points), delaunay_bonds_in_order(points));
}

TEST(DelaunayBonds, SayWherePointsCoincide) {
  PointArray points(5, 2);
  points << 0, 0, 1, 0, 0, 1, 1, 1, 1, 0;
  EXPECT_INPUT_ERROR(delaunay_bonds(points), "two points coincide, at (1, 0)");
}

}  // namespace
}  // namespace impact
