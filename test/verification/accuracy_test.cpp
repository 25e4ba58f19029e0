#include "verification/accuracy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace impact {
namespace {

constexpr double kWanted = 1e-6;

/// An answer that errs by `true_error` and estimates `estimated_error`, all in wanted errors; the
/// reference to `reference_error`.
AccuracyCheck made_up(double true_error, double estimated_error, double reference_error = 1e-3) {
  AccuracyCheck check;
  check.rejected = 0;
  check.scene.numerics.error = kWanted;
  check.reference = {0.8, reference_error * kWanted, "made up", {}};
  check.trial = {AccuracyTrial::kAnswered,  "verlet", 0.01, 0.8 * (1.0 + true_error * kWanted),
                 estimated_error * kWanted, 0.0};
  return check;
}

AccuracyCheck refused(const std::string& status) {
  AccuracyCheck check = made_up(0.0, 0.5);
  check.trial.status = status;
  return check;
}

TEST(Verdict, CatchesAMadeUpWrongAnswer) {
  EXPECT_EQ(verdict(made_up(0.9, 0.5)), Verdict::kKept);
  EXPECT_EQ(verdict(made_up(1.1, 0.5)), Verdict::kBroken);
  EXPECT_EQ(verdict(made_up(-1.1, 0.5)), Verdict::kBroken);
  EXPECT_EQ(verdict(made_up(std::numeric_limits<double>::quiet_NaN(), 0.5)), Verdict::kBroken);
}

/// An answer is broken only beyond the reference's own error, and kept only where that is small.
TEST(Verdict, RespectsTheErrorOfTheReference) {
  EXPECT_EQ(verdict(made_up(1.05, 0.5, 0.1)), Verdict::kKept);
  EXPECT_EQ(verdict(made_up(0.9, 0.5, 0.2)), Verdict::kNoReference);
  EXPECT_EQ(verdict(made_up(2.0, 0.5, 5.0)), Verdict::kUndefined);
  EXPECT_EQ(verdict(made_up(50.0, 0.5, 5.0)), Verdict::kUndefined);
  EXPECT_EQ(verdict(made_up(52.0, 0.5, 5.0)), Verdict::kBroken);
  EXPECT_EQ(verdict(made_up(0.9, 0.5, std::numeric_limits<double>::infinity())),
            Verdict::kNoReference);
}

TEST(Verdict, CountsRefusals) { EXPECT_EQ(verdict(refused("no rest")), Verdict::kRefused); }

/// Whatever happens is a status: here points that cannot be triangulated.
TEST(TryScene, TurnsErrorsIntoAStatus) {
  Scene scene;
  scene.disk.recipe.points = 2;
  const AccuracyTrial trial = try_scene(scene);
  EXPECT_NE(trial.status, AccuracyTrial::kAnswered);
  EXPECT_TRUE(std::isnan(trial.answer));
}

TEST(EstimateQuality, CountsWhatIsKnownWellEnough) {
  const EstimateQuality quality = estimate_quality({
      made_up(0.5, 0.5),           // as estimated
      made_up(0.9, 0.01),          // 90 times the estimate
      made_up(0.9, 0.001),         // 900 times
      made_up(0.0, 0.5),           // less than 1/100
      made_up(0.006, 0.5, 0.004),  // 0.012, give or take 0.008
      made_up(0.9, 0.01, 0.2),     // 90, give or take 20
      refused("no rest"),
  });
  EXPECT_EQ(quality.ratios.size(), 4);
  EXPECT_EQ(quality.within, 2);
  EXPECT_EQ(quality.unknown, 2);
  EXPECT_NEAR(quality.ratios.front(), 0.0, 1e-9);
  EXPECT_NEAR(quality.ratios.back(), 900.0, 1e-6 * 900.0);
}

TEST(ErrorsOverWanted, RiseAndLeaveOutWhatHasNoReference) {
  const std::vector<double> errors = errors_over_wanted(
      {made_up(3.0, 0.5), made_up(0.5, 0.5), made_up(0.7, 0.5, 0.5), refused("no rest")});
  ASSERT_EQ(errors.size(), 2);
  EXPECT_NEAR(errors[0], 0.5, 1e-8);
  EXPECT_NEAR(errors[1], 3.0, 1e-8);
}

TEST(Counts, AreByVerdictAndByCause) {
  const std::vector<AccuracyCheck> checks{
      made_up(0.5, 0.5), made_up(3.0, 0.5), refused("a step of 1e-05 R/c, more than 3e+05 steps"),
      refused("a step of 0.2 R/c, more than 12 steps"), refused("the lattice folds")};
  const auto verdicts = count_verdicts(checks);
  EXPECT_EQ(verdicts.at(Verdict::kKept), 1);
  EXPECT_EQ(verdicts.at(Verdict::kBroken), 1);
  EXPECT_EQ(verdicts.at(Verdict::kRefused), 3);
  const auto refusals = count_refusals(checks);
  EXPECT_EQ(refusals.size(), 2);
  EXPECT_EQ(refusals.at("a step of # R/c, more than # steps"), 2);
  EXPECT_EQ(refusals.at("the lattice folds"), 1);
}

}  // namespace
}  // namespace impact
