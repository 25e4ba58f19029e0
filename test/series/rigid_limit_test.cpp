#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/body_motion.hpp"
#include "series/experiment.hpp"

namespace impact {
namespace {

/// A rigid disk that one point stops: the contact's lever arm x about the centre of mass turns it,
/// and e = (k² − x²)/(k² + x²) with k² = I/M.
double rigid_restitution(const Lattice& lattice) {
  const BodyMotion body = body_motion(lattice.points, PointArray::Zero(lattice.points.rows(), 2));
  Eigen::Index lowest = 0;
  lattice.points.col(1).minCoeff(&lowest);
  const double square = std::pow(lattice.points(lowest, 0) - body.centre.x(), 2);
  return (body.moment_of_inertia - square) / (body.moment_of_inertia + square);
}

class RigidLimit : public testing::TestWithParam<std::uint64_t> {};  // over seeds with x < k

/// On a wall so hard that a second point does not touch it, so slowly that the force changes at the
/// rate a v = 0.1 c/R, far below the lowest frequency: no vibration stays. (At a tenth of the speed
/// e is the same to 10⁻⁷.) While the wall pushes, over some 1/a, the disk turns and changes its
/// lever arm.
TEST_P(RigidLimit, OfASlowDiskWithoutDamping) {
  Scene scene;
  scene.seed = GetParam();
  scene.disk.recipe = {7, Placement::kBlueNoise, false};
  scene.wall.a = 1e5;
  scene.impact.velocity = 1e-6;
  Experiment experiment(scene);
  while (!experiment.finished()) experiment.advance();
  const double tolerance = 10.0 / scene.wall.a;
  EXPECT_NEAR(experiment.answer(), rigid_restitution(experiment.run().lattice()), tolerance);
  EXPECT_NEAR(experiment.impact().value.energy_restitution, 1.0, tolerance);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RigidLimit, testing::Range<std::uint64_t>(2, 7));

}  // namespace
}  // namespace impact
