#include "measure/strain.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace impact {
namespace {

/// 400 points evenly on the unit circle, one of them at the bottom.
PointArray circle() {
  PointArray points(400, 2);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / 400.0 - M_PI / 2.0;
    points.row(i) << std::cos(angle), std::sin(angle);
  }
  return points;
}

TEST(StrainMeter, OfAFlattenedCircle) {
  PointArray position = circle();
  position.col(1) *= 0.98;
  position.col(1) += 5.0;
  const Strain strain = StrainMeter(circle()).measure(position);
  EXPECT_NEAR(strain.height, 0.98, 1e-14);
  EXPECT_NEAR(strain.reference_height, 1.0, 1e-14);
  EXPECT_NEAR(strain.strain(), 0.02, 1e-14);
  EXPECT_NEAR(strain.strain_from_radius(), 0.02, 1e-14);
  EXPECT_NEAR(strain.rotation, 0.0, 1e-14);
}

/// A rigid motion is no strain, whatever the shape.
TEST(StrainMeter, RigidMotionIsNoStrain) {
  PointArray reference = circle();
  reference.col(0) *= 1.3;
  const double angle = 0.7;
  PointArray position(reference.rows(), 2);
  position.col(0) = std::cos(angle) * reference.col(0) - std::sin(angle) * reference.col(1) + 3.0;
  position.col(1) = std::sin(angle) * reference.col(0) + std::cos(angle) * reference.col(1) - 2.0;
  const Strain strain = StrainMeter(reference).measure(position);
  EXPECT_NEAR(strain.strain(), 0.0, 1e-14);
  EXPECT_NEAR(strain.rotation, angle, 1e-14);
  EXPECT_GT(strain.reference_height, 1.1);
}

}  // namespace
}  // namespace impact
