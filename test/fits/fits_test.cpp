#include "fits/fits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sample_disk.hpp"
#include "theory/quasi_static.hpp"

namespace impact {
namespace {

std::vector<DataPoint> restitution_data(double d1, double d2, double noise, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> error(0.0, noise);
  std::vector<DataPoint> points;
  for (int k = 0; k < 20; ++k) {
    const double velocity = 0.002 * std::pow(20.0, k / 19.0);
    points.push_back({velocity, closed_form_restitution(d1, d2, velocity) + error(random)});
  }
  return points;
}

TEST(FitHertz, RecoversBExactlyWithoutNoise) {
  std::vector<DataPoint> points;
  for (double force = 4e-3; force < 1e-2; force += 1e-3) {
    points.push_back({force, hertz_compression(kDisk, 1.55, force)});
  }
  const Fit fit = fit_hertz(points, kDisk);
  ASSERT_TRUE(fit.declined.empty()) << fit.declined;
  EXPECT_NEAR(fit.parameters[0].value, 1.55, 1e-8);
  EXPECT_LT(fit.residual, 1e-9);
  EXPECT_EQ(fit.points, points.size());
  EXPECT_EQ(fit.x_low, 4e-3);
}

/// Two values y ± δ of one force: χ² = 2δ² on one degree of freedom, so that the mean, which the
/// law meets, is known to δ, and b to δ over the slope of the law.
TEST(FitHertz, HasTheErrorOfTheScatter) {
  constexpr double kForce = 6e-3;
  constexpr double kDelta = 1e-5;
  const double y = hertz_compression(kDisk, 1.55, kForce);
  const Fit fit = fit_hertz({{kForce, y + kDelta}, {kForce, y - kDelta}}, kDisk);
  ASSERT_TRUE(fit.declined.empty()) << fit.declined;
  constexpr double kMove = 1e-5;
  const double slope = (hertz_compression(kDisk, 1.55 + kMove, kForce) -
                        hertz_compression(kDisk, 1.55 - kMove, kForce)) /
                       (2.0 * kMove);
  // The solver's slopes are forward differences with steps of 10⁻⁸.
  EXPECT_NEAR(fit.parameters[0].standard_error, kDelta / slope, 1e-5 * kDelta / slope);
}

/// Over 200 noisy data sets the estimates scatter as their standard errors say: the mean of the
/// squared normalised deviation is 1 (by t statistics n/(n − 2) for n = 18 degrees: 1.125), known
/// from 200 sets to √(2/200) = 0.1.
TEST(FitRestitution, ErrorsAreWhatTheyClaim) {
  constexpr int kSets = 200;
  double sum1 = 0.0;
  double sum2 = 0.0;
  for (unsigned seed = 1; seed <= kSets; ++seed) {
    const Fit fit = fit_restitution(restitution_data(0.973, 0.119, 3e-4, seed));
    ASSERT_TRUE(fit.declined.empty()) << fit.declined;
    sum1 += std::pow((fit.parameters[0].value - 0.973) / fit.parameters[0].standard_error, 2);
    sum2 += std::pow((fit.parameters[1].value - 0.119) / fit.parameters[1].standard_error, 2);
  }
  EXPECT_NEAR(sum1 / kSets, 1.125, 0.4);
  EXPECT_NEAR(sum2 / kSets, 1.125, 0.4);
}

/// Losses so strong that the law's root ends not far beyond the data. 10⁻³ of noise leaves d₂ known
/// to some per cent.
TEST(FitRestitution, RecoversStrongLosses) {
  const Fit fit = fit_restitution(restitution_data(1.5, 1.7, 1e-3, 1));
  ASSERT_TRUE(fit.declined.empty()) << fit.declined;
  EXPECT_NEAR(fit.parameters[0].value, 1.5, 3.5 * fit.parameters[0].standard_error);
  EXPECT_NEAR(fit.parameters[1].value, 1.7, 3.5 * fit.parameters[1].standard_error);
  EXPECT_LT(fit.parameters[1].standard_error, 0.05);
}

/// d₂ of about its standard error and a half, by which it may be taken for chance.
TEST(FitRestitution, DeclinesAWeakSlope) {
  int declined = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const Fit fit = fit_restitution(restitution_data(1.0, 0.02, 1e-3, seed));
    declined += fit.declined.empty() ? 0 : 1;
    if (!fit.declined.empty()) continue;
    EXPECT_GT(fit.parameters[1].value, 2.0 * fit.parameters[1].standard_error);
  }
  EXPECT_GT(declined, 20);
  EXPECT_LT(declined, 95);
}

TEST(FitRestitution, DeclinesAConcaveLaw) {
  std::vector<DataPoint> points;
  for (int k = 1; k <= 20; ++k) {
    const double velocity = 0.002 * k;
    points.push_back({velocity, 1.0 - 8.0 * velocity * velocity});
  }
  const Fit fit = fit_restitution(points);
  EXPECT_NE(fit.declined.find("lacks the convex shape"), std::string::npos) << fit.declined;
  EXPECT_TRUE(fit.parameters.empty());
}

TEST(FitRestitution, DeclinesWhatItCannotTell) {
  EXPECT_NE(fit_restitution({{0.01, 0.9}, {0.02, 0.8}}).declined.find("fewer than four"),
            std::string::npos);
  EXPECT_NE(fit_restitution({{0.01, 0.9}, {0.02, 0.8}, {0.03, 0.7}, {5.0, 0.6}})
                .declined.find("no value at some of the points"),
            std::string::npos);
  std::vector<DataPoint> noise = restitution_data(1.0, 0.0, 1e-3, 1);
  EXPECT_FALSE(fit_restitution(noise).declined.empty());
}

}  // namespace
}  // namespace impact
