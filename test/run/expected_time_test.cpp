#include "run/expected_time.hpp"

#include <gtest/gtest.h>

namespace impact {
namespace {

/// The way down and up again takes twice the gap over the speed.
TEST(ExpectedTime, CountsTheWayThereAndBack) {
  const Scene scene;
  EXPECT_NEAR(expected_time(scene, 100, 0.75, 0.0) - expected_time(scene, 100, 0.25, 0.0),
              2.0 * 0.5 / 0.01, 1e-9);
}

/// Through a row the impact goes once, over each gap and by a contact a disk.
TEST(ExpectedTime, GoesThroughTheRow) {
  Scene scene;
  scene.wall.kind = WallKind::kDisk;
  const double contact = expected_time(scene, 100, 0.0, 0.1);
  scene.wall.disks = 3;
  EXPECT_NEAR(expected_time(scene, 100, 0.0, 0.1), 3.0 * contact + 2.0 * 0.1 / 0.01, 1e-9);
}

/// a R m c², half of it where both ends of the contact move.
TEST(Repulsion, GoesWithTheMassOfAPoint) {
  Scene scene;
  EXPECT_DOUBLE_EQ(repulsion(scene, 100).potential_at(0.0), 300.0 / 100);
  scene.wall.kind = WallKind::kLattice;
  EXPECT_DOUBLE_EQ(repulsion(scene, 100).potential_at(0.0), 0.5 * 300.0 / 100);
  scene.wall.v0 = 0.1;
  EXPECT_DOUBLE_EQ(repulsion(scene, 100).potential_at(0.0), 0.1);
}

/// A hundredth of the wanted 10⁻⁴ of the kinetic energy.
TEST(NegligibleWallEnergy, GoesWithTheWantedError) {
  EXPECT_DOUBLE_EQ(negligible_wall_energy(Scene{}), 0.01 * 1e-4 * 0.5 * 0.01 * 0.01);
}

/// 0.01 c times 0.004 R/c: the least multiple that is not below the height.
TEST(OnWholeResets, NeverComesNearer) {
  Scene scene;
  EXPECT_EQ(on_whole_resets(scene, 0.1234567), 0.1234567);
  scene.wall.kind = WallKind::kLattice;
  EXPECT_DOUBLE_EQ(on_whole_resets(scene, 10.1 * 4e-5), 11 * 4e-5);
  scene.wall.boundary = Boundary::kFixed;
  EXPECT_EQ(on_whole_resets(scene, 0.1234567), 0.1234567);
}

}  // namespace
}  // namespace impact
