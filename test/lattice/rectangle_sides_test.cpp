#include "lattice/rectangle_sides.hpp"

#include <gtest/gtest.h>

#include "expect_input_error.hpp"
#include "lattice/placement.hpp"

namespace impact {
namespace {

using Indices = std::vector<std::int32_t>;

/// 3 × 2 points of a square grid, stored in no order, all neighbours bonded.
///   4 0 2
///   1 5 3
PointArray grid() {
  PointArray points(6, 2);
  points << 1, 1, 0, 0, 2, 1, 2, 0, 0, 1, 1, 0;
  return points;
}
const std::vector<Bond> kGridBonds{{1, 5}, {3, 5}, {0, 4}, {0, 2}, {1, 4}, {0, 5}, {2, 3}};

TEST(RectangleSides, AreInOrderAndShareTheCorners) {
  const RectangleSides sides = rectangle_sides(make_lattice(grid(), kGridBonds));
  EXPECT_EQ(sides.left, (Indices{1, 4}));
  EXPECT_EQ(sides.right, (Indices{3, 2}));
  EXPECT_EQ(sides.bottom, (Indices{1, 5, 3}));
  EXPECT_EQ(sides.top, (Indices{4, 0, 2}));
}

/// Coordinates that went through a file or a shift differ in their last digits.
TEST(RectangleSides, ForgiveRounding) {
  PointArray points = grid();
  points(0, 1) += 1e-10;
  points(4, 0) -= 1e-10;
  const RectangleSides sides = rectangle_sides(make_lattice(points, kGridBonds));
  EXPECT_EQ(sides.left, (Indices{1, 4}));
  EXPECT_EQ(sides.top, (Indices{4, 0, 2}));
  points(0, 1) += 1e-6;
  points(2, 1) = points(0, 1);
  EXPECT_EQ(rectangle_sides(make_lattice(points, kGridBonds)).top, (Indices{0, 2}));
}

TEST(RectangleSides, RefuseABrokenTopSide) {
  std::vector<Bond> bonds = kGridBonds;
  bonds[3] = {0, 3};  // instead of {0, 2}
  EXPECT_INPUT_ERROR(rectangle_sides(make_lattice(grid(), bonds)),
                     "points 1 and 3 are neighbours on the top side but not bonded");
}

TEST(RectangleSides, RefuseATopOfOnePoint) {
  PointArray points(3, 2);
  points << 0, 0, 2, 0, 1, 1;
  EXPECT_INPUT_ERROR(rectangle_sides(make_lattice(points, {{0, 1}, {0, 2}, {1, 2}})),
                     "the top side has fewer than two points");
}

/// Every point of a placed rim is found: all those with a coordinate on the outline.
TEST(RectangleSides, FindTheRimOfAPlacedRectangle) {
  for (const Placement placement : {Placement::kUniform, Placement::kBlueNoise}) {
    const Lattice lattice =
        triangulated_lattice(place_in_rectangle({1269, placement, true}, 2.69, 1.345, 3));
    const RectangleSides sides = rectangle_sides(lattice);
    EXPECT_EQ((lattice.points.col(0) == -2.69 / 2).count(), sides.left.size());
    EXPECT_EQ((lattice.points.col(0) == 2.69 / 2).count(), sides.right.size());
    EXPECT_EQ((lattice.points.col(1) == -1.345 / 2).count(), sides.bottom.size());
    EXPECT_EQ((lattice.points.col(1) == 1.345 / 2).count(), sides.top.size());
    EXPECT_EQ(sides.left.back(), sides.top.front());
    EXPECT_EQ(sides.right.back(), sides.top.back());
    EXPECT_EQ(sides.right.front(), sides.bottom.back());
  }
}

}  // namespace
}  // namespace impact
