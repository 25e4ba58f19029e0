#include "statics/folding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "test_lattices.hpp"

namespace impact {
namespace {

/// With its bonds sorted.
Lattice patch(int side) {
  const Lattice lattice = triangular_patch(side);
  return make_lattice(lattice.points, lattice.bonds);
}

/// Euler's formula for a patch of s × s points: 2 (s − 1)² triangles.
TEST(Triangles, FindsAllOfAPatch) {
  for (const int side : {2, 3, 6}) {
    EXPECT_EQ(Triangles(patch(side)).size(), 2U * (side - 1) * (side - 1));
  }
}

/// Wherever the bonds of a point begin to be counted around it.
TEST(Triangles, AreTheSameAtEveryAngle) {
  const Lattice lattice = patch(4);
  for (int k = 1; k < 12; ++k) {
    const double angle = k * M_PI / 6.0 + 0.1;
    PointArray turned(lattice.points.rows(), 2);
    turned << std::cos(angle) * lattice.points.col(0) - std::sin(angle) * lattice.points.col(1),
        std::sin(angle) * lattice.points.col(0) + std::cos(angle) * lattice.points.col(1);
    EXPECT_EQ(Triangles(make_lattice(turned, lattice.bonds)).size(), 2U * 3 * 3) << angle;
  }
}

/// The three bonds around a point are corners of three triangles; the outer three points are bonded
/// to each other too, but have the point between them.
TEST(Triangles, LeavesOutWhatHasAPointInside) {
  PointArray points(4, 2);
  points << 0, 0, 2, 0, 1, 2, 1, 0.7;
  const Lattice lattice = plain_lattice(points, {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}});
  EXPECT_EQ(Triangles(lattice).size(), 3U);
}

/// The sides of a patch; and a point that lies just behind one of them.
TEST(Triangles, KnowThePointsThatComeIntoContactFirst) {
  const Lattice lattice = patch(5);
  const std::vector<std::int32_t> sides = Triangles(lattice).outer_points(lattice, 0.1);
  EXPECT_EQ(sides.size(), 16U);
  for (const std::int32_t point : sides) {
    const auto bonds = std::count_if(
        lattice.bonds.begin(), lattice.bonds.end(),
        [&](const Bond& bond) { return bond.first == point || bond.second == point; });
    EXPECT_LT(bonds, 6);
  }
  PointArray points = lattice.points;
  const std::int32_t middle = 12;
  EXPECT_FALSE(std::binary_search(sides.begin(), sides.end(), middle));
  const auto bottom = points(2, 1);
  const std::int32_t behind = 7;
  ASSERT_FALSE(std::binary_search(sides.begin(), sides.end(), behind));
  points(behind, 1) = bottom + 0.05;
  const Lattice pressed = make_lattice(points, lattice.bonds);
  const std::vector<std::int32_t> outer = Triangles(pressed).outer_points(pressed, 0.1);
  EXPECT_EQ(outer.size(), 17U);
  EXPECT_TRUE(std::binary_search(outer.begin(), outer.end(), behind));
}

TEST(Triangles, TurnOverWhereAPointPassesThroughABond) {
  const Lattice lattice = patch(5);
  const Triangles triangles(lattice);
  PointArray position = lattice.points;
  EXPECT_EQ(triangles.turned_over(position), 0U);
  position(12, 1) -= 0.8;  // the middle point, whose row lies √(3/4) above the next
  EXPECT_EQ(triangles.turned_over(position), 0U);
  position(12, 1) -= 0.2;  // through the bond below
  EXPECT_EQ(triangles.turned_over(position), 1U);
}

/// Of a triangle between the point and the bond that it is pressed towards, the height that is
/// left.
TEST(Triangles, KnowTheLeastPartOfTheirArea) {
  const Lattice lattice = patch(5);
  const Triangles triangles(lattice);
  PointArray position = lattice.points;
  EXPECT_DOUBLE_EQ(triangles.least_area_left(lattice.points, position), 1.0);
  const double height = std::sqrt(0.75);
  position(12, 1) -= 0.8;
  EXPECT_NEAR(triangles.least_area_left(lattice.points, position), 1.0 - 0.8 / height, 1e-12);
  position(12, 1) -= 0.2;
  EXPECT_NEAR(triangles.least_area_left(lattice.points, position), 1.0 - 1.0 / height, 1e-12);
}

/// Turning the body, or stretching it, folds nothing; a mirror image turns over all.
TEST(Triangles, KnowADeformationFromAFold) {
  const Lattice lattice = patch(4);
  const Triangles triangles(lattice);
  PointArray position(lattice.points.rows(), 2);
  position << -3.0 * lattice.points.col(1), 0.1 * lattice.points.col(0);
  EXPECT_EQ(triangles.turned_over(position), 0U);
  position.col(0) = -position.col(0);
  EXPECT_EQ(triangles.turned_over(position), triangles.size());
}

}  // namespace
}  // namespace impact
