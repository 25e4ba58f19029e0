#include "mechanics/rotation_hold.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "mechanics/body_motion.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

PointArray random_forces(Eigen::Index count) {
  std::srand(3);
  return PointArray::Random(count, 2);
}

/// After apply() no force turns the reference: Σ R_i × f_i = 0; the resultant is untouched.
TEST(RotationHold, LeavesNoTorqueAndNoResultant) {
  const PointArray reference = triangular_patch(4).points;
  const PointArray arm = reference.rowwise() - reference.colwise().mean();
  PointArray force = random_forces(16);
  const PointArray before = force;
  RotationHold hold(reference);
  hold.constrain(force);

  const auto torque = [&](const PointArray& f) {
    return (arm.col(0) * f.col(1) - arm.col(1) * f.col(0)).sum();
  };
  // Rounding of sums of 32 terms of order 1.
  EXPECT_NEAR(torque(force), 0.0, 1e-13);
  EXPECT_NEAR((force - before).col(0).sum(), 0.0, 1e-13);
  EXPECT_NEAR((force - before).col(1).sum(), 0.0, 1e-13);
  EXPECT_NEAR(hold.torque(), -torque(before), 1e-13);
}

/// Displacements that satisfy the constraint have no best-fitting rotation at all, however large.
TEST(RotationHold, AllowedDisplacementsDoNotRotate) {
  const PointArray reference = triangular_patch(4).points;
  PointArray displacement = random_forces(16);
  RotationHold(reference).constrain(displacement);
  EXPECT_NEAR(rigid_rotation(reference, reference + displacement), 0.0, 1e-14);
}

}  // namespace
}  // namespace impact
