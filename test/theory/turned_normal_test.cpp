#include "theory/turned_normal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace impact {
namespace {

constexpr double kRounding = 1e-14;

TEST(RestitutionOnSlope, OfALevelSurfaceIsThatAlongItsNormal) {
  EXPECT_DOUBLE_EQ(restitution_on_slope(0.9, 0.0, 0.0), 0.9);
  EXPECT_DOUBLE_EQ(restitution_on_slope(0.9, 0.0, 5.0), 0.9);
}

/// The mirror image turns the slope and the velocity along x.
TEST(RestitutionOnSlope, OfTheMirrorImageIsTheSame) {
  EXPECT_EQ(restitution_on_slope(0.9, 0.1, 2.0), restitution_on_slope(0.9, -0.1, -2.0));
  EXPECT_GT(restitution_on_slope(0.9, 0.1, 2.0), 0.9);
  EXPECT_LT(restitution_on_slope(0.9, -0.1, 2.0), 0.9);
}

/// The velocity reflected at the turned normal, by vectors.
TEST(RestitutionOnSlope, IsThatOfAReflectionAtTheTurnedNormal) {
  for (const double alpha : {-0.3, 0.0, 0.05, 0.6}) {
    const double gamma = 0.8;
    const std::complex<double> before(std::sin(gamma), -std::cos(gamma));
    const std::complex<double> normal(-std::sin(alpha), std::cos(alpha));
    const double along_normal = (before * std::conj(normal)).real();
    const std::complex<double> after = before - 1.7 * along_normal * normal;
    EXPECT_NEAR(restitution_on_slope(0.7, std::tan(alpha), std::tan(gamma)),
                -after.imag() / before.imag(), kRounding);
  }
}

TEST(RestitutionAlongNormal, IsTheInverse) {
  const double on_slope = restitution_on_slope(0.9, 0.07, 3.0);
  EXPECT_NEAR(restitution_along_normal(on_slope, 0.07, 3.0), 0.9, kRounding);
}

}  // namespace
}  // namespace impact
