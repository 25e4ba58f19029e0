#include "theory/hertz.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_disk.hpp"

namespace impact {
namespace {

TEST(HertzCompression, ByHand) {
  const double force = M_PI * 1.1 * 0.001;  // P/(πE) = 0.001
  EXPECT_NEAR(hertz_compression(kDisk, 2.0, force), 0.002 * (std::log(2000.0) - 1.27), 1e-15);
}

/// physics of §4: eq. (2) fits the exact law with b ≈ 0.92 over the paper's loads.
TEST(InertialLoadCompression, IsWhatEq2GivesWithBNear092) {
  for (const double force : {4e-3, 1e-2}) {
    const double exact = inertial_load_compression(kDisk, force);
    EXPECT_NEAR(hertz_compression(kDisk, 0.92, force) / exact, 1.0, 0.02);
  }
}

/// The pressure carries the force: the area of a half-ellipse.
TEST(ContactPressure, IntegratesToTheForce) {
  const double a = contact_half_width(kDisk, 0.01);
  double sum = 0.0;
  constexpr int kStrips = 100000;
  for (int k = 0; k < kStrips; ++k) {
    sum += contact_pressure(kDisk, 0.01, a * (-1.0 + (2.0 * k + 1.0) / kStrips));
  }
  // The midpoint rule at the square-root ends errs by (strip width)^1.5.
  EXPECT_NEAR(sum * 2.0 * a / kStrips, 0.01, 1e-8);
  EXPECT_EQ(contact_pressure(kDisk, 0.01, 1.01 * a), 0.0);
}

}  // namespace
}  // namespace impact
