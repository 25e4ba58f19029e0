#include "fits/quasi_static_impact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_disk.hpp"

namespace impact {
namespace {

/// Without dissipation the disk comes back with the speed that it had.
TEST(QuasiStaticRestitution, WithoutDissipationIsOne) {
  for (const double v : {1e-4, 0.01, 0.1}) {
    const QuasiStaticImpact impact{kModulus, 0.0, v};
    EXPECT_NEAR(
        quasi_static_restitution(impact, EndOfImpact::kNoCompression, sound_speed(kModulus)), 1.0,
        1e-9);
  }
}

/// At small τ₀ the loss 1 − e² is linear in τ₀: half of it for half the τ₀.
TEST(QuasiStaticRestitution, LossIsLinearInTheDissipationTime) {
  const auto loss = [](double dissipation_time) {
    const double e = quasi_static_restitution({kModulus, dissipation_time, 0.01},
                                              EndOfImpact::kNoCompression, 0.0 + 1.86);
    return 1.0 - e * e;
  };
  EXPECT_NEAR(loss(2e-5) / loss(1e-5), 2.0, 1e-3);
}

/// As checked in the reading of the paper: eq. (4) loses about half of what eq. (5) says with the
/// paper's d₂, 0.498 of it at low v.
TEST(QuasiStaticRestitution, LosesHalfOfWhatTheClosedFormSays) {
  const double c = sound_speed(kModulus);
  const QuasiStaticImpact impact{kModulus, 1e-5, 1e-4};
  const double e = quasi_static_restitution(impact, EndOfImpact::kNoCompression, c);
  const double closed = closed_form_restitution(1.0, paper_d2(impact, c), impact.velocity / c);
  EXPECT_NEAR((1.0 - e * e) / (1.0 - closed * closed), 0.5, 0.02);
}

/// The relative tolerances: 10⁻⁹ of the root, and 10⁻⁹ of e over the loss 1 − e² that it feeds.
TEST(DissipationTime, InvertsTheRestitution) {
  for (const double v : {1e-3, 0.01, 0.1}) {
    for (const double wanted : {1e-3, 0.02, 0.3}) {
      const double e = quasi_static_restitution({kModulus, wanted, v}, EndOfImpact::kNoCompression,
                                                sound_speed(kModulus));
      const double loss = 1.0 - e * e;
      EXPECT_NEAR(dissipation_time(kModulus, v, loss) / wanted, 1.0, 1e-9 + 2e-9 / loss);
    }
  }
}

TEST(DissipationTime, OfNoLossIsZero) { EXPECT_EQ(dissipation_time(kModulus, 0.01, 0.0), 0.0); }

TEST(DissipationTime, ReachesNearlyEveryLoss) {
  EXPECT_GT(dissipation_time(kModulus, 0.01, 0.999999), 0.0);
  EXPECT_GT(dissipation_time(kModulus, 0.99 * sound_speed(kModulus), 0.999), 0.0);
}

TEST(DissipationTime, IsNotANumberWhereThereIsNone) {
  const double c = sound_speed(kModulus);
  EXPECT_TRUE(std::isnan(dissipation_time(kModulus, 0.01, -1e-6)));
  EXPECT_TRUE(std::isnan(dissipation_time(kModulus, 0.01, 1.0)));
  EXPECT_TRUE(std::isnan(dissipation_time(kModulus, c, 0.1)));
  EXPECT_TRUE(std::isnan(dissipation_time(std::nan(""), 0.01, 0.1)));
  EXPECT_TRUE(std::isnan(dissipation_time(kModulus, 0.01, std::nan(""))));
}

}  // namespace
}  // namespace impact
