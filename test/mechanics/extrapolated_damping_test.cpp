#include "mechanics/extrapolated_damping.hpp"

#include <gtest/gtest.h>

#include "linear_mode.hpp"

namespace impact {
namespace {

double radius(double omega, double gamma) {
  return spectral_radius<ExtrapolatedDamping>(omega * omega, gamma);
}

TEST(ExtrapolatedDampingStepLimit, DependsOnTheDamping) {
  constexpr double kOmegaSquared = 4.0;
  constexpr double kEnough = 0.03 * 3.0 * 2.0;
  const ExtrapolatedDamping integrator;
  EXPECT_DOUBLE_EQ(integrator.step_limit(kOmegaSquared, 0.0), 0.75);
  EXPECT_DOUBLE_EQ(integrator.step_limit(kOmegaSquared, 0.99 * kEnough), 0.75);
  EXPECT_DOUBLE_EQ(integrator.step_limit(kOmegaSquared, 1.01 * kEnough), 1.5);
}

/// Without damping a mode grows by less than 10⁻³ a step up to ω h = 1.5, and by more soon after;
/// any damping makes it less.
TEST(ExtrapolatedDampingStepLimit, IsTheEdgeOfNegligibleGrowthWithoutDamping) {
  for (const double gamma : {0.0, 1e-4, 1e-2, 1.0, 100.0}) {
    for (double omega = 0.01; omega < 1.501; omega += 0.01) {
      EXPECT_LT(radius(omega, gamma), 1.0 + 1e-3) << omega << " " << gamma;
    }
  }
  EXPECT_GT(radius(1.6, 0.0), 1.0 + 1e-3);
}

/// With γ ≥ 0.03 ω² h up to ω h = 3, and not much further.
TEST(ExtrapolatedDampingStepLimit, IsTheEdgeOfStabilityWithDamping) {
  for (const double rate : {0.03, 0.1, 1.0, 1e2, 1e5}) {
    for (double omega = 0.01; omega < 3.001; omega += 0.01) {
      EXPECT_LE(radius(omega, rate * omega * omega), 1.0) << omega << " " << rate;
    }
  }
  EXPECT_GT(radius(3.1, 0.03 * 3.1 * 3.1), 1.0);
  EXPECT_GT(radius(3.0, 0.01 * 3.0 * 3.0), 1.0);
}

}  // namespace
}  // namespace impact
