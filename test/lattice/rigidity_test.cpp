#include "lattice/rigidity.hpp"

#include <gtest/gtest.h>

#include "lattice/placement.hpp"

namespace impact {
namespace {

PointArray square() {
  PointArray points(4, 2);
  points << 0, 0, 1, 0, 1, 1, 0, 1;
  return points;
}

TEST(Floppy, IsASquareWithoutADiagonal) {
  EXPECT_TRUE(is_floppy(make_lattice(square(), {{0, 1}, {1, 2}, {2, 3}, {0, 3}})));
  EXPECT_FALSE(is_floppy(make_lattice(square(), {{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 2}})));
}

/// Bonds enough, but too many of them in one half: a square with both diagonals, and one without
/// on its side.
TEST(Floppy, IsAMechanismBesideASurplusOfBonds) {
  PointArray points(6, 2);
  points << square(), PointArray{{2.0, 0.0}, {2.0, 1.0}};
  std::vector<Bond> bonds{{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 2}, {1, 3}, {1, 4}, {4, 5}, {2, 5}};
  ASSERT_EQ(bonds.size(), 9U);
  EXPECT_TRUE(is_floppy(make_lattice(points, bonds)));
  bonds.push_back({1, 5});
  EXPECT_FALSE(is_floppy(make_lattice(points, bonds)));
}

TEST(Floppy, IsNoTriangulation) {
  for (const int n : {3, 10, 1000, 20000}) {
    EXPECT_FALSE(
        is_floppy(triangulated_lattice(place_in_disk({n, Placement::kUniform, false}, 1))));
  }
}

}  // namespace
}  // namespace impact
