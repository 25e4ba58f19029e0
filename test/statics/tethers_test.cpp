#include "statics/tethers.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lattice/placement.hpp"
#include "lattice/triangulation.hpp"

namespace impact {
namespace {

/// Two ways of length 1, each to a third of the points: the distance of a corner from the centre
/// of mass, 1/√3, is shorter.
TEST(Tethers, OfATriangle) {
  PointArray points(3, 2);
  points << 0.0, 0.0, 1.0, 0.0, 0.5, std::sqrt(0.75);
  const Tethers tethers(make_lattice(points, {{0, 1}, {0, 2}, {1, 2}}));
  EXPECT_NEAR(tethers.largest_distance(0.0), 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(tethers.largest_distance(0.3), 2.0 / 3.0 + 0.3 * std::sqrt(2.0) / 3.0, 1e-15);
}

/// Folded at its middle, then drawn out by what the energy allows: 2 bonds of 1 + x.
TEST(Tethers, HoldTheEndOfAChain) {
  PointArray points(4, 2);
  points << 0.0, 0.0, 1.0, 0.0, 2.0, 0.0, 1.0, 0.1;
  const Lattice lattice = make_lattice(points, {{0, 1}, {1, 2}, {1, 3}});
  // From an end: 1 to the middle, 2 to the other end, 1.1 to the side.
  EXPECT_NEAR(Tethers(lattice).largest_distance(0.0), 4.1 / 4.0, 1e-15);
  // Three quarters beyond the first bond, a quarter each beyond the two others.
  EXPECT_NEAR(Tethers(lattice).largest_distance(1.0), 4.1 / 4.0 + std::sqrt(11.0) / 4.0, 1e-15);
}

/// The mean distance of a point of the rim from all of a disk is 32/(9π) R; ways along bonds are up
/// to an eighth longer.
TEST(Tethers, AreLittleLongerThanDistances) {
  const double mean = 32.0 / (9.0 * M_PI);
  for (const int points : {300, 5000}) {
    const Tethers tethers(triangulated_lattice(place_in_disk({points}, 1)));
    EXPECT_GT(tethers.largest_distance(0.0), mean);
    EXPECT_LT(tethers.largest_distance(0.0), 1.125 * mean);
  }
}

TEST(ConvexHull, LeavesOutPointsInside) {
  PointArray points(6, 2);
  points << 0.5, 0.5, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.5, 0.0;
  EXPECT_EQ(convex_hull(points), (std::vector<Eigen::Index>{3, 1, 4, 2}));
}

}  // namespace
}  // namespace impact
