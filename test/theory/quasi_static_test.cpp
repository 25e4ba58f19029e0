#include "theory/quasi_static.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_disk.hpp"

namespace impact {
namespace {

TEST(ContactTime, ByHand) {
  EXPECT_NEAR(sound_speed(kModulus), std::sqrt(M_PI * kModulus), 1e-15);
  EXPECT_NEAR(contact_time(2.0, 8.0 * std::exp(-4.0)), M_PI / 2.0 * 2.0, 1e-14);
}

TEST(ClosedForm, ByHand) {
  EXPECT_NEAR(closed_form_restitution(0.9, 0.5, 4.0 * std::exp(-4.0)), 0.9 * std::sqrt(0.75),
              1e-15);
  EXPECT_TRUE(std::isnan(closed_form_restitution(1.0, 3.0, 4.0 * std::exp(-4.0))));
}

/// 2π τ₀ E*/(ρ R c_s) with the density 1/π.
TEST(PaperD2, ByHand) { EXPECT_NEAR(paper_d2({0.5, 0.1, 0.01}, 2.0), 0.05 * M_PI * M_PI, 1e-15); }

}  // namespace
}  // namespace impact
