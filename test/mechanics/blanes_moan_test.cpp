#include "mechanics/blanes_moan.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "linear_mode.hpp"

namespace impact {
namespace {

/// By how much a mode grows in a step.
double growth(double omega) { return spectral_radius<BlanesMoan>(omega * omega, 0.0) - 1.0; }

/// Up to the limit all is stable, save for the two resonances, which are as narrow and as weak as
/// documented.
TEST(BlanesMoanStepLimit, IsTheEdgeOfStability) {
  constexpr double kRounding = 1e-12;
  const double limit = BlanesMoan().step_limit(1.0, 0.0);
  EXPECT_EQ(limit, BlanesMoan::kLimit);
  bool first_seen = false;
  bool second_seen = false;
  for (int k = 1; k < 90700; ++k) {
    const double omega = 1e-4 * k;
    if (k >= 31415 && k <= 31424) {
      EXPECT_LT(growth(omega), 5e-4);
      first_seen = first_seen || growth(omega) > 4e-4;
    } else if (k >= 63479 && k <= 63493) {
      EXPECT_LT(growth(omega), 7e-4);
      second_seen = second_seen || growth(omega) > 6e-4;
    } else {
      ASSERT_LT(growth(omega), kRounding) << omega;
    }
  }
  EXPECT_TRUE(first_seen);
  EXPECT_TRUE(second_seen);
  EXPECT_LT(growth(0.999 * limit), kRounding);
  EXPECT_GT(growth(1.001 * limit), 0.01);
}

}  // namespace
}  // namespace impact
