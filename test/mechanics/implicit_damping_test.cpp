#include "mechanics/implicit_damping.hpp"

#include <gtest/gtest.h>

#include "linear_mode.hpp"

namespace impact {
namespace {

/// ω h = 2, whatever the damping: from there on the mode that turns round each step grows.
TEST(ImplicitDampingStepLimit, IsTheEdgeOfStability) {
  for (const double gamma : {0.0, 0.01, 1.0, 100.0, 1e6}) {
    const double limit = ImplicitDamping().step_limit(1.0, gamma);
    const double inside = 0.999 * limit;
    const double outside = 1.001 * limit;
    EXPECT_LE(spectral_radius<ImplicitDamping>(inside * inside, gamma), 1.0 + 1e-12) << gamma;
    EXPECT_GT(spectral_radius<ImplicitDamping>(outside * outside, gamma), 1.0 + 1e-9) << gamma;
  }
}

}  // namespace
}  // namespace impact
