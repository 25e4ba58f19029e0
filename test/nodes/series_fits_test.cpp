#include "nodes/series_fits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fits/quasi_static_impact.hpp"
#include "scene/scene_parameters.hpp"
#include "theory/hertz.hpp"

namespace impact {
namespace {

constexpr double kModulus = 1.082;  // of the default recipe
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Scene collision(double velocity, double eta, std::uint64_t seed = 1) {
  Scene scene;
  scene.impact.velocity = velocity;
  scene.material.eta = eta;
  scene.seed = seed;
  return scene;
}

Scene contact(double p) {
  Scene scene;
  scene.kind = SceneKind::kContact;
  scene.material.eta = 100.0;
  scene.load.p = p;
  return scene;
}

/// The fits of a series, and what they say.
struct Series {
  explicit Series(const ElasticParameters& elastic = {})
      : fits(elastic, [this](const lattice_impact::LawFit& law) { said.push_back(law); }) {}

  void run(const Scene& scene, double answer, const std::vector<std::string>& flags = {}) {
    fits.add({{}, next++, scene, flags, answer});
  }

  std::vector<lattice_impact::LawFit> said;
  SeriesFits fits;
  std::uint32_t next = 0;
};

std::vector<double> velocities() {
  std::vector<double> result;
  for (int k = 0; k < 20; ++k) result.push_back(0.004 * std::pow(20.0, k / 19.0));
  return result;
}

TEST(SeriesFits, AveragesByAngle) {
  Series series;
  const auto thrown = [&](double angle, std::uint64_t seed, double e) {
    Scene scene = collision(0.05, 0.0, seed);
    scene.impact.angle = angle;
    series.run(scene, e);
  };
  thrown(30.0, 1, 0.90);
  EXPECT_EQ(series.said.size(), 1U);  // by velocity alone
  thrown(0.0, 1, 0.94);
  thrown(30.0, 2, 0.92);
  const lattice_impact::LawFit& law = series.said.back();
  EXPECT_EQ(law.law, "restitution_by_angle");
  EXPECT_EQ(law.x, (std::vector<double>{0.0, 30.0}));
  EXPECT_DOUBLE_EQ(law.y[1], 0.91);
  EXPECT_NEAR(law.y_standard_error[1], 0.01, 1e-15);
  EXPECT_EQ(law.runs, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_FALSE(YAML::Load(law.scene)["impact"]["angle"]);
  series.run(collision(0.1, 0.0), 0.8);
  EXPECT_EQ(series.said.back().law, "restitution");
}

/// 3.5 standard errors: with t statistics of 18 degrees of freedom 0.3 % of the seeds fail, and
/// these do not.
TEST(SeriesFits, RecoversTheRestitutionLaw) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 3e-4);
  Series series;
  for (const double v : velocities()) {
    const double x = v / sound_speed(kModulus);
    series.run(collision(v, 10.0), closed_form_restitution(0.973, 0.119, x) + noise(random));
  }
  ASSERT_EQ(series.said.size(), 20U);
  EXPECT_EQ(series.said[0].declined, "fewer than four points");
  const lattice_impact::LawFit& law = series.said.back();
  EXPECT_EQ(law.declined, "");
  EXPECT_EQ(law.law, "restitution");
  EXPECT_EQ(law.run, 19U);
  EXPECT_EQ(law.names, (std::vector<std::string>{"d1", "d2"}));
  EXPECT_NEAR(law.values[0], 0.973, 3.5 * law.standard_errors[0]);
  EXPECT_NEAR(law.values[1], 0.119, 3.5 * law.standard_errors[1]);
  EXPECT_LT(law.standard_errors[1], 0.01);
  // From 20 points the scatter is known to √(1/40) = 16 %; two parameters take 5 %.
  EXPECT_NEAR(law.residual, 3e-4, 1.5e-4);
  EXPECT_EQ(law.x_low, law.x.front());
  EXPECT_EQ(law.x_high, law.x.back());
  EXPECT_DOUBLE_EQ(law.x.front() * law.sound_speed, 0.004);
}

TEST(SeriesFits, RecoversTheHertzLaw) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 1e-4);
  Series series;
  for (double p = 4e-3; p < 1e-2; p += 5e-4) {
    series.run(contact(p), hertz_compression({kModulus, 0.276}, 1.3, p) + noise(random));
  }
  const lattice_impact::LawFit& law = series.said.back();
  EXPECT_EQ(law.declined, "");
  EXPECT_EQ(law.law, "hertz");
  EXPECT_NEAR(law.values[0], 1.3, 3.5 * law.standard_errors[0]);
  EXPECT_LT(law.standard_errors[0], 0.05);
  EXPECT_EQ(law.paper_values[0], 1.55);
  EXPECT_EQ(law.young_modulus, kModulus);
  EXPECT_EQ(law.poisson_ratio, 0.276);
  EXPECT_EQ(law.x.front(), 4e-3);
  EXPECT_EQ(law.y_theory.size(), law.x.size());
  EXPECT_EQ(law.y_inertial_load.size(), law.x.size());
}

TEST(SeriesFits, KeepsGroupsApart) {
  Series series;
  series.run(collision(0.01, 1.0), 0.99);
  series.run(collision(0.01, 10.0), 0.9);
  Scene finer = collision(0.02, 10.0);
  finer.numerics.error = 1e-5;
  series.run(finer, 0.8);
  series.run(collision(0.02, 1.0), 0.98);
  series.run(contact(0.004), 0.01);
  ASSERT_EQ(series.said.size(), 5U);
  EXPECT_EQ(series.said[1].y, std::vector<double>{0.9});
  EXPECT_EQ(series.said[2].y, std::vector<double>{0.8});
  EXPECT_EQ(series.said[3].y, (std::vector<double>{0.99, 0.98}));
  EXPECT_EQ(series.said[3].scene, series.said[0].scene);
  EXPECT_NE(series.said[3].scene, series.said[1].scene);
  EXPECT_EQ(series.said[4].law, "hertz");
}

TEST(SeriesFits, SaysWhatTheRunsShare) {
  Series series;
  series.run(collision(0.01, 1.0), 0.99);
  const YAML::Node shared = YAML::Load(series.said[0].scene);
  EXPECT_EQ(shared["material"]["eta"].as<double>(), 1.0);
  EXPECT_FALSE(shared["seed"]);
  EXPECT_FALSE(shared["impact"]["velocity"]);
  EXPECT_TRUE(shared["impact"]["gap"]);
}

TEST(SeriesFits, AveragesOverSeeds) {
  Series series;
  series.run(collision(0.02, 10.0, 1), 0.7);
  series.run(collision(0.01, 10.0, 1), 0.90);
  series.run(collision(0.01, 10.0, 2), 0.94);
  const lattice_impact::LawFit& law = series.said.back();
  ASSERT_EQ(law.x.size(), 2U);
  EXPECT_LT(law.x[0], law.x[1]);
  EXPECT_DOUBLE_EQ(law.y[0], 0.92);
  EXPECT_NEAR(law.y_standard_error[0], 0.02, 1e-15);  // the values round at 10⁻¹⁶
  EXPECT_TRUE(std::isnan(law.y_standard_error[1]));
  EXPECT_EQ(law.runs, (std::vector<std::uint32_t>{2, 1}));
}

TEST(SeriesFits, LeavesOutAndCountsWhatHasNoSoundAnswer) {
  Series series;
  series.run(collision(0.01, 10.0), 0.9);
  series.run(collision(0.02, 10.0), kNaN);
  series.run(collision(0.03, 10.0), 0.8, {"energy_error"});
  series.run(collision(0.04, 10.0), 0.7, {"step_reduced"});
  const lattice_impact::LawFit& law = series.said.back();
  EXPECT_EQ(law.left_out, 2U);
  EXPECT_EQ(law.y, (std::vector<double>{0.9, 0.7}));
}

TEST(SeriesFits, OfNoAnswerIsEmpty) {
  Series series;
  series.run(collision(0.01, 10.0), kNaN);
  EXPECT_TRUE(series.said[0].x.empty());
  EXPECT_EQ(series.said[0].left_out, 1U);
  EXPECT_NE(series.said[0].declined, "");
}

TEST(SeriesFits, DeclinesAConcaveLaw) {
  Series series;
  for (const double v : velocities()) series.run(collision(v, 0.0), 1.0 - 5.0 * v * v);
  const lattice_impact::LawFit& law = series.said.back();
  EXPECT_NE(law.declined.find("lacks the convex shape"), std::string::npos) << law.declined;
  EXPECT_TRUE(std::isnan(law.values[0]) && std::isnan(law.standard_errors[1]));
  EXPECT_TRUE(std::isnan(law.residual));
}

/// Nothing dissipates: eq. (4) gives back all energy, to its own tolerance of 10⁻⁹.
TEST(SeriesFits, TheoryWithoutDampingIsElastic) {
  Series series;
  series.run(collision(0.01, 0.0), 0.98);
  EXPECT_EQ(series.said[0].dissipation_time, 0.0);
  EXPECT_NEAR(series.said[0].y_theory[0], 1.0, 1e-9);
}

/// The theory meets the measured loss at the greatest velocity, within the 10⁻⁹ of both
/// integrations over the loss.
TEST(SeriesFits, DissipationIsThatOfTheGreatestVelocity) {
  Series series;
  series.run(collision(0.02, 10.0), 0.8);
  series.run(collision(0.01, 10.0), 0.9);
  const lattice_impact::LawFit& law = series.said.back();
  EXPECT_NEAR(law.y_theory[1], 0.8, 1e-7);
  EXPECT_GT(law.y_theory[0], 0.8);
  EXPECT_EQ(law.dissipation_time_origin, "all loss at v = 0.02 c");
}

/// Where an undamped run tells what goes into vibrations, τ₀ stands for the rest; whichever of the
/// two comes first.
TEST(SeriesFits, DissipationIsInExcessOfTheUndampedLoss) {
  const double wanted = 0.03;
  const double e = quasi_static_restitution({kModulus, wanted, 0.02}, EndOfImpact::kNoCompression,
                                            sound_speed(kModulus));
  const double undamped = 0.99;
  const double damped = std::sqrt(e * e - (1.0 - undamped * undamped));
  for (const bool undamped_first : {true, false}) {
    Series series;
    series.run(collision(0.05, 10.0), 0.5);
    if (undamped_first) series.run(collision(0.02, 0.0), undamped);
    series.run(collision(0.02, 10.0), damped);
    if (!undamped_first) series.run(collision(0.02, 0.0), undamped);
    const auto law = std::find_if(series.said.rbegin(), series.said.rend(),
                                  [](const auto& said) { return said.x.size() == 2; });
    ASSERT_NE(law, series.said.rend());
    EXPECT_NEAR(law->dissipation_time / wanted, 1.0, 1e-7);
    EXPECT_EQ(law->dissipation_time_origin, "loss in excess of that with η* = 0 at v = 0.02 c");
    EXPECT_EQ(law->run, 2U);
  }
}

TEST(SeriesFits, HasNoDissipationTimeForAGain) {
  Series series;
  series.run(collision(0.02, 10.0), 1.001);
  EXPECT_TRUE(std::isnan(series.said[0].dissipation_time));
  EXPECT_TRUE(std::isnan(series.said[0].y_theory[0]));
}

TEST(SeriesFits, OfALatticeFromAFileNeedsItsConstants) {
  Scene scene = contact(0.004);
  scene.disk.file = "mine.data";
  Series without;
  without.run(scene, 0.01);
  EXPECT_TRUE(std::isnan(without.said[0].y_theory[0]));
  EXPECT_NE(without.said[0].declined.find("not known"), std::string::npos);
  Series with({1.2, 0.3});
  with.run(scene, 0.01);
  EXPECT_EQ(with.said[0].y_theory[0], hertz_compression({1.2, 0.3}, 1.0 - 0.3 * 0.3, 0.004));
  EXPECT_EQ(with.said[0].young_modulus_origin, "parameter young_modulus");
}

}  // namespace
}  // namespace impact
