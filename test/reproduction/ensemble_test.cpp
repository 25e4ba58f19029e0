#include "reproduction/ensemble.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "theory/quasi_static.hpp"

namespace impact {
namespace {

Row row(std::uint64_t seed, double velocity, double restitution, const std::string& flags = {}) {
  Row row{Scene{}, {{"restitution", restitution}}, flags};
  row.scene.seed = seed;
  row.scene.impact.velocity = velocity;
  return row;
}

double velocity(const Scene& scene) { return scene.impact.velocity; }

TEST(Ensemble, GathersACurveForEachSeed) {
  const Ensemble curves = ensemble({row(1, 0.02, 0.9), row(2, 0.02, 0.8), row(1, 0.01, 0.95),
                                    row(2, 0.01, 0.85, "step_reduced")},
                                   velocity, "restitution");
  EXPECT_EQ(curves.x, (std::vector<double>{0.01, 0.02}));
  EXPECT_EQ(curves.y, (std::vector<std::vector<double>>{{0.95, 0.9}, {0.85, 0.8}}));
}

TEST(Ensemble, LeavesOutLatticesWithFlags) {
  const Ensemble curves = ensemble({row(1, 0.01, 0.95), row(1, 0.02, 0.9), row(2, 0.01, 0.85),
                                    row(2, 0.02, 0.8, "energy_error")},
                                   velocity, "restitution");
  EXPECT_EQ(curves.y, (std::vector<std::vector<double>>{{0.95, 0.9}}));
}

TEST(Ensemble, MeanCurve) {
  const auto curve = mean_curve({{1.0, 2.0}, {{1.0, 5.0}, {3.0, 5.0}}});
  EXPECT_EQ(curve[0].y, 2.0);
  EXPECT_DOUBLE_EQ(curve[0].standard_error, 1.0);
  EXPECT_EQ(curve[1].standard_error, 0.0);
  EXPECT_EQ(curve[1].runs, 2U);
}

TEST(Ensemble, Every) {
  std::vector<Row> rows;
  for (int k = 0; k < 6; ++k) rows.push_back(row(1, k, 0.0));
  const auto chosen = every(rows, 1, 2, 3);
  ASSERT_EQ(chosen.size(), 4U);
  EXPECT_EQ(chosen[0].scene.impact.velocity, 1.0);
  EXPECT_EQ(chosen[2].scene.impact.velocity, 4.0);
  EXPECT_EQ(chosen[3].scene.impact.velocity, 5.0);
  const auto first_of_each = every(rows, 0, 1, 3);
  ASSERT_EQ(first_of_each.size(), 2U);
  EXPECT_EQ(first_of_each[1].scene.impact.velocity, 3.0);
}

/// For a mean the jackknife is the standard error of the mean, exactly.
TEST(FitEnsemble, JackknifeOfAMeanIsItsStandardError) {
  const Ensemble curves{{0.0}, {{1.0}, {2.0}, {4.0}, {9.0}}};
  const EnsembleFit fit = fit_ensemble(curves, [](const std::vector<DataPoint>& points) {
    Fit mean;
    mean.parameters = {{points[0].y, 0.0}};
    return mean;
  });
  EXPECT_DOUBLE_EQ(fit.fit.parameters[0].value, 4.0);
  EXPECT_NEAR(fit.sampling_error[0], mean_curve(curves)[0].standard_error, 1e-14);
}

/// Curves of eq. (5), each with a d₂ of its own and noise on top.
Ensemble synthetic_curves(int lattices, double d1, double d2) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  Ensemble curves;
  for (int k = 0; k < 10; ++k) curves.x.push_back(0.003 * std::pow(1.4, k));
  for (int i = 0; i < lattices; ++i) {
    const double own = d2 + 0.02 * normal(random);
    std::vector<double>& y = curves.y.emplace_back();
    for (const double x : curves.x) {
      y.push_back(closed_form_restitution(d1, own, x) + 1e-3 * normal(random));
    }
  }
  return curves;
}

/// Both parameters lie within three of their own errors; 20 lattices whose d₂ scatter by 0.02 leave
/// an error near 0.02/√20.
TEST(FitEnsemble, RecoversTheLawWithinItsErrors) {
  const EnsembleFit fit = fit_ensemble(synthetic_curves(20, 0.98, 0.3), fit_restitution);
  ASSERT_EQ(fit.fit.declined, "");
  EXPECT_NEAR(fit.fit.parameters[0].value, 0.98, 3.0 * fit.sampling_error[0]);
  EXPECT_NEAR(fit.fit.parameters[1].value, 0.3, 3.0 * fit.sampling_error[1]);
  EXPECT_LT(fit.sampling_error[1], 2.0 * 0.02 / std::sqrt(20.0) + 0.005);
  EXPECT_GT(fit.sampling_error[1], 0.5 * 0.02 / std::sqrt(20.0));
}

TEST(FitEnsemble, OneLatticeHasNoSamplingError) {
  const EnsembleFit fit = fit_ensemble(synthetic_curves(1, 0.98, 0.3), fit_restitution);
  ASSERT_EQ(fit.fit.declined, "");
  EXPECT_TRUE(std::isnan(fit.sampling_error[0]));
}

}  // namespace
}  // namespace impact
