#include "nodes/run_checks.hpp"

#include <gtest/gtest.h>

namespace impact {
namespace {

/// Of the first state of a disk of three points that comes down at this velocity.
std::string fault_at_start(const Scene& scene, double velocity) {
  lattice_impact::Lattice lattice;
  lattice.x = lattice.y = {0.0, 1.0, 2.0};
  lattice.bond_first = {0};
  lattice.bond_second = {1};
  lattice.natural_length = {1.0};
  lattice_impact::ParticleStates states;
  states.x = lattice.x;
  states.y = lattice.y;
  states.vx = {0.0, 0.0, 0.0};
  states.vy = {-velocity, -velocity, -velocity};
  lattice_impact::ContactForces forces;
  forces.sample_time = forces.sample_force = {0.0};
  lattice_impact::RunStatus status;
  status.step_size = 0.01;
  RunChecks checks;
  EXPECT_EQ(checks.fault_of(lattice), "");
  return checks.fault_of(states, forces, scene, status, true);
}

TEST(RunChecks, KnowTheVelocityOfTheScene) {
  Scene scene;
  scene.impact.velocity = 0.04;
  EXPECT_EQ(fault_at_start(scene, 0.04), "");
  EXPECT_EQ(fault_at_start(scene, 0.03), "velocity -0.03 c at the start, of the scene -0.04");
}

/// As seen from the centre of mass of the disk and of a row of three as heavy as it.
TEST(RunChecks, CountAllDisksOfARow) {
  Scene scene;
  scene.wall.kind = WallKind::kDisk;
  scene.wall.disks = 3;
  scene.impact.velocity = 0.04;
  EXPECT_EQ(fault_at_start(scene, 0.03), "");
  EXPECT_NE(fault_at_start(scene, 0.02), "");
}

}  // namespace
}  // namespace impact
