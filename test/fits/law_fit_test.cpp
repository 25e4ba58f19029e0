#include "fits/law_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fits/quasi_static_impact.hpp"
#include "sample_disk.hpp"

namespace impact {
namespace {

TEST(HertzLawFit, ShowsTheoryBesideTheFit) {
  const ElasticDisk disk{kModulus, 0.27};
  std::vector<MeanPoint> points;
  for (const double force : {4e-3, 6e-3, 8e-3}) {
    points.push_back(mean_point(force, {hertz_compression(disk, 1.3, force)}));
  }
  const LawFit law = hertz_law_fit(points, disk);
  EXPECT_TRUE(law.fit.declined.empty()) << law.fit.declined;
  ASSERT_EQ(law.parameters.size(), 1U);
  EXPECT_EQ(law.parameters[0].name, "b");
  EXPECT_EQ(law.parameters[0].paper, 1.55);
  EXPECT_NEAR(law.parameters[0].estimate.value, 1.3, 1e-8);  // the fit stops at 10⁻¹² of χ²
  ASSERT_EQ(law.theory.size(), 3U);
  EXPECT_EQ(law.theory[1], hertz_compression(disk, 1.0 - 0.27 * 0.27, 6e-3));
  EXPECT_EQ(law.inertial_load[1], inertial_load_compression(disk, 6e-3));
}

TEST(HertzLawFit, DeclinesAnUnknownDisk) {
  const LawFit law =
      hertz_law_fit({mean_point(4e-3, {0.01}), mean_point(6e-3, {0.02})}, {kModulus, LawFit::kNaN});
  EXPECT_NE(law.fit.declined.find("not known"), std::string::npos) << law.fit.declined;
  EXPECT_TRUE(std::isnan(law.parameters[0].estimate.value));
  EXPECT_TRUE(std::isnan(law.theory[0]));
}

/// A point of three runs pulls the fit as three points of one run do.
TEST(HertzLawFit, WeighsPointsByTheirRuns) {
  const ElasticDisk disk{kModulus, 0.27};
  const MeanPoint once = mean_point(4e-3, {0.01});
  const MeanPoint thrice = mean_point(8e-3, {0.02, 0.02, 0.02});
  const MeanPoint one_of_three = mean_point(8e-3, {0.02});
  const LawFit together = hertz_law_fit({once, thrice}, disk);
  const LawFit apart = hertz_law_fit({once, one_of_three, one_of_three, one_of_three}, disk);
  ASSERT_TRUE(together.fit.declined.empty());
  // Both minima are found to about 10⁻⁸, the square root of the spacing of doubles.
  EXPECT_NEAR(together.parameters[0].estimate.value, apart.parameters[0].estimate.value, 1e-7);
}

TEST(RestitutionLawFit, HasTheTheoryOfTheGivenDissipation) {
  const double c = sound_speed(kModulus);
  const LawFit law =
      restitution_law_fit({mean_point(0.01 / c, {0.9}), mean_point(1.0, {0.8})}, kModulus, 0.02);
  ASSERT_EQ(law.theory.size(), 2U);
  // x c_s is 0.01 but for rounding.
  EXPECT_NEAR(law.theory[0],
              quasi_static_restitution({kModulus, 0.02, 0.01}, EndOfImpact::kNoCompression, c),
              1e-9);
  EXPECT_TRUE(std::isnan(law.theory[1]));
  EXPECT_EQ(law.fit.declined, "fewer than four points");
  EXPECT_EQ(law.parameters[1].name, "d2");
  EXPECT_TRUE(std::isnan(law.parameters[1].paper));
}

TEST(RestitutionLawFit, IsNotKnownWithoutConstants) {
  const LawFit law =
      restitution_law_fit({mean_point(LawFit::kNaN, {0.9})}, LawFit::kNaN, LawFit::kNaN);
  EXPECT_NE(law.fit.declined.find("not known"), std::string::npos) << law.fit.declined;
  EXPECT_TRUE(std::isnan(law.theory[0]));
}

}  // namespace
}  // namespace impact
