#include "mechanics/body_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test_lattices.hpp"

namespace impact {
namespace {

PointArray turned(const PointArray& points, double angle) {
  PointArray result(points.rows(), 2);
  result.col(0) = std::cos(angle) * points.col(0) - std::sin(angle) * points.col(1);
  result.col(1) = std::sin(angle) * points.col(0) + std::cos(angle) * points.col(1);
  return result;
}

/// A triangle of side 1 and mass 1 has the moment of inertia 1/3 about its middle.
TEST(BodyMotion, OfASpinningFlyingTriangle) {
  const PointArray position = triangle().points;
  const PointArray arm = position.rowwise() - position.colwise().mean();
  PointArray velocity(3, 2);
  velocity.col(0) = 0.5 - 2.0 * arm.col(1);
  velocity.col(1) = -0.25 + 2.0 * arm.col(0);
  const BodyMotion motion = body_motion(position, velocity);
  EXPECT_NEAR(motion.centre.x(), 0.5, 1e-15);
  EXPECT_NEAR(motion.centre.y(), std::sqrt(0.75) / 3.0, 1e-15);
  EXPECT_NEAR(motion.velocity.x(), 0.5, 1e-15);
  EXPECT_NEAR(motion.velocity.y(), -0.25, 1e-15);
  EXPECT_NEAR(motion.moment_of_inertia, 1.0 / 3.0, 1e-15);
  EXPECT_NEAR(motion.spin(), 2.0, 1e-14);
}

TEST(RigidRotation, FindsTheAngle) {
  const PointArray reference = triangular_patch(3).points;
  for (const double angle : {-3.0, -1.0, 0.0, 0.5, 3.0}) {
    const PointArray position = turned(reference, angle) + 4.0;
    EXPECT_NEAR(rigid_rotation(reference, position), angle, 1e-14);
  }
}

}  // namespace
}  // namespace impact
