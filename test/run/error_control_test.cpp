#include "run/error_control.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace impact {
namespace {

constexpr double kTrue = 0.9;  ///< e

Scene scene_with(double error, IntegratorKind integrator = IntegratorKind::kVerlet) {
  Scene scene;
  scene.disk.recipe.points = 30;
  scene.impact.velocity = 0.05;
  scene.numerics.error = error;
  scene.numerics.integrator = integrator;
  return scene;
}

/// A made-up method: what e and its tail come to with a step.
struct Method {
  std::function<double(double)> error = [](double /*step*/) { return 0.0; };  ///< relative
  std::function<void(FinishedImpact&)> change = [](FinishedImpact& /*run*/) {};
};

/// Feeds the control with runs of the method until it is content.
struct Play {
  Play(const Scene& scene, const Method& method) : control(scene, compose(scene)) {
    for (bool accepted = false; !accepted; ++runs) {
      FinishedImpact run;
      run.step = control.resolution().step;
      run.steps = static_cast<std::uint64_t>(10.0 / run.step);
      run.measured.velocity_before = -scene.impact.velocity;
      const double e = kTrue * (1.0 + method.error(run.step));
      for (const auto& [name, number] : impact_numbers<Restitution>()) run.measured.*number = e;
      run.measured.velocity_after = e * scene.impact.velocity;
      method.change(run);
      steps.push_back(run.step);
      accepted = control.accepts(run);
    }
  }

  double true_error() const { return std::abs(control.answer().value.restitution / kTrue - 1.0); }

  ErrorControl control;
  std::vector<double> steps;
  int runs = 0;
};

TEST(ErrorControl, ComparesThreeRunsEachFinerThanTheLast) {
  const Play play(scene_with(1e-4), {});
  EXPECT_EQ(play.runs, 3);
  EXPECT_DOUBLE_EQ(play.steps[0] / play.steps[1], kRefinement);
  EXPECT_DOUBLE_EQ(play.steps[1] / play.steps[2], kRefinement);
}

TEST(ErrorControl, ForeseesTheRunsThatItAsksFor) {
  const Scene scene = scene_with(1e-4);
  const ErrorControl control(scene, compose(scene));
  const Play play(scene, {});
  ASSERT_EQ(control.later_resolutions().size(), 2U);
  EXPECT_EQ(control.resolution().step, play.steps[0]);
  EXPECT_EQ(control.later_resolutions()[0].step, play.steps[1]);
  EXPECT_EQ(control.later_resolutions()[1].step, play.steps[2]);
}

/// Errors of many sizes and powers, alone and mixed: the answer is within the wanted error and
/// within the estimated one, and it comes.
TEST(ErrorControl, AnswersWithinTheWantedErrorWhateverTheOrder) {
  for (const double wanted : {1e-2, 1e-4, 1e-6, 1e-8}) {
    for (const double power : {1.0, 1.5, 2.0, 3.0, 4.0, 6.0}) {
      for (const double size : {1e-6, 1e-4, 1e-2}) {
        const auto error = [=](double h) { return size * std::pow(h / 0.01, power); };
        const Method method{error};
        try {
          const Play play(scene_with(wanted), method);
          EXPECT_LE(play.true_error(), play.control.estimated_error()) << power << " " << size;
          EXPECT_LE(play.control.estimated_error(), wanted);
        } catch (const RunFailure&) {
          // An error of a power that the method should not have may need too many steps.
          EXPECT_TRUE(power < 2.0 || power == 3.0) << power;
          EXPECT_GE(size, wanted);
        }
      }
    }
  }
}

/// The extrapolated answer needs steps that leave one run by itself with a hundred times the error.
TEST(ErrorControl, ExtrapolatesWhereTheOrderIsSeen) {
  const Play play(scene_with(1e-6), {[](double h) { return h * h * (1.0 + h * h); }});
  EXPECT_EQ(play.runs, 3);
  const double of_run = play.steps.back() * play.steps.back();
  EXPECT_GT(of_run, 20e-6);
  EXPECT_LT(play.true_error(), 1e-6);
  EXPECT_NEAR(play.control.answer().error_of_run, kTrue * of_run, 0.01 * of_run);
}

/// Where a point crosses the wall's range in two steps, agreement with an order is chance.
TEST(ErrorControl, SeesNoOrderInStepsTooLongForTheWall) {
  const auto error = [](double h) { return 1e3 * std::pow(h, 6); };
  for (const double a : {300.0, 100.0}) {
    Scene scene = scene_with(1e-2, IntegratorKind::kBlanesMoan);
    scene.wall.a = a;
    const Play play(scene, {error});
    const bool too_long = a * scene.impact.velocity * play.steps.front() > 0.5;
    EXPECT_EQ(too_long, a == 300.0);
    const double of_run = kTrue * (1.0 + error(play.steps.back()));
    EXPECT_EQ(play.control.answer().value.restitution == of_run, too_long);
  }
}

/// Runs that are too coarse to show the order, and those a little finer that do: it does not give
/// up while the coarse ones are still compared with.
TEST(ErrorControl, GoesOnWhereTheOrderIsSeenLate) {
  const auto error = [](double h) {
    return h > 0.021 ? 1e-4 * std::sin(1e3 * h) : 2.7e-5 * (h / 0.02) * (h / 0.02);
  };
  for (const double wanted : {1e-5, 1e-6, 1e-8}) {
    const Play play(scene_with(wanted), {error});
    EXPECT_LE(play.true_error(), wanted);
  }
}

/// Scatter above the wanted error ends with its cause, hardly ever with an answer.
TEST(ErrorControl, DoesNotTakeScatterForAnAnswer) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> scatter(-1.0, 1.0);
  int wrong = 0;
  for (int k = 0; k < 200; ++k) {
    const Method method{[&](double /*h*/) { return 1e-3 * scatter(random); },
                        [](FinishedImpact& run) { run.folded = true; }};
    try {
      const Play play(scene_with(1e-4), method);
      wrong += play.true_error() > 1e-4 ? 1 : 0;
    } catch (const RunFailure& failure) {
      EXPECT_NE(std::string(failure.what()).find("the lattice folds"), std::string::npos);
    }
  }
  EXPECT_LE(wrong, 1);
}

TEST(ErrorControl, ComparesFiveRunsWhereTheLatticeFoldsOrTheWallIsCutOff) {
  const Method folding{{[](double h) { return 1e-3 * h * h; }},
                       [](FinishedImpact& run) { run.folded = true; }};
  const Method cut_off{{[](double h) { return 1e-3 * h * h; }},
                       [](FinishedImpact& run) { run.cut_off = true; }};
  for (const Method& method : {folding, cut_off}) {
    const Play play(scene_with(1e-4), method);
    EXPECT_EQ(play.runs, 5);
    const double finest = play.steps.back();
    EXPECT_DOUBLE_EQ(play.control.answer().value.restitution,
                     kTrue * (1.0 + 1e-3 * finest * finest));
  }
}

TEST(ErrorControl, DoesNotExtrapolateOverHopsThatMatter) {
  for (const double hops : {1e-5, 1e-3}) {
    const Method method{{[](double h) { return 1e-3 * h * h; }},
                        [hops](FinishedImpact& run) { run.error_by_hops = hops; }};
    const Play play(scene_with(1e-4), method);
    const double of_run = kTrue * (1.0 + 1e-3 * play.steps.back() * play.steps.back());
    EXPECT_EQ(play.control.answer().value.restitution == of_run, hops > 1e-4);
  }
}

/// A hop is seen up to a step late, by which the force has changed by a v h: agreement of the runs
/// does not take that away.
TEST(ErrorControl, CountsHopsThatAreSeenLate) {
  const double hops = 1e-3;
  const Method method{[](double /*h*/) { return 0.0; },
                      [hops](FinishedImpact& run) { run.error_by_hops = hops; }};
  const Scene scene = scene_with(1e-3);
  const Play play(scene, method);
  EXPECT_GE(play.control.estimated_error(),
            hops * scene.wall.a * scene.impact.velocity * play.steps.back());
  const Play exact(scene_with(1e-5), method);
  EXPECT_LE(exact.control.estimated_error(), 1e-5);
  EXPECT_LT(exact.steps.back(), 0.1 * play.steps.back());
}

/// The wall's tail, up to a tenth of the wanted error, is in the estimate.
TEST(ErrorControl, CountsTheTailOfTheWall) {
  const double tail = 0.09e-4;
  const Method method{[tail](double /*h*/) { return tail; },
                      [tail](FinishedImpact& run) { run.tail_error = tail; }};
  const Play play(scene_with(1e-4), method);
  EXPECT_GE(play.control.estimated_error(), tail);
  EXPECT_GE(play.control.answer().error.impulse, tail * kTrue);
}

/// A start whose tail is felt is lifted until it is not: e^(a lift) times less.
TEST(ErrorControl, LiftsAStartThatIsTooNear) {
  const Scene scene = scene_with(1e-4);
  ErrorControl control(scene, compose(scene));
  FinishedImpact run;
  run.tail_error = 1e-3;
  run.measured.velocity_after = 0.01;
  ASSERT_FALSE(control.accepts(run));
  EXPECT_NEAR(std::exp(-scene.wall.a * control.resolution().lift), 0.5 * 1e-5 / 1e-3, 1e-6);
  ASSERT_EQ(control.later_resolutions().size(), 2U);
  EXPECT_EQ(control.later_resolutions().back().lift, control.resolution().lift);
}

TEST(ErrorControl, LeavesAGivenGapAsItIs) {
  Scene scene = scene_with(1e-4);
  scene.impact.gap = 0.1;
  ErrorControl control(scene, compose(scene));
  FinishedImpact run;
  run.tail_error = 1e-3;
  ASSERT_FALSE(control.accepts(run));
  EXPECT_EQ(control.resolution().lift, 0.0);
}

/// Differences that are nothing but rounding are an answer, with an error of that size.
TEST(ErrorControl, AcceptsWhatOnlyRoundingTellsApart) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> rounding(-1e-14, 1e-14);
  for (int k = 0; k < 50; ++k) {
    const Play play(scene_with(1e-10), {[&](double /*h*/) { return rounding(random); }});
    EXPECT_EQ(play.runs, 3);
    EXPECT_LE(play.true_error(), play.control.estimated_error());
    EXPECT_GE(play.control.estimated_error(), 16.0 * 2.2e-16 * std::sqrt(10.0 / 0.02));
  }
}

/// Runs whose step had to be shortened on the way are not compared, even if they agree.
TEST(ErrorControl, DoesNotCountRunsOfReducedStep) {
  int reduced = 0;
  const Method method{[](double /*h*/) { return 0.0; },
                      [&reduced](FinishedImpact& run) {
                        if (++reduced > 3) return;
                        run.step_reduced = true;
                        run.step *= 0.5;
                        run.measured.restitution = 0.5;
                      }};
  const Play play(scene_with(1e-4), method);
  EXPECT_EQ(play.runs, 6);
  EXPECT_EQ(play.control.answer().value.restitution, kTrue);
  EXPECT_LE(play.steps[1], 0.5 * play.steps[0] / kRefinement * (1.0 + 1e-12));
}

TEST(ErrorControl, GivesUpADiskThatDoesNotLeave) {
  const Method method{{[](double /*h*/) { return 0.0; }},
                      [](FinishedImpact& run) { run.not_separated = true; }};
  EXPECT_THROW(Play(scene_with(1e-4), method), RunFailure);
}

/// Where the step is given the run is the answer, and nothing is said of its error.
TEST(ErrorControl, TakesARunOfGivenStepAsItIs) {
  Scene scene = scene_with(1e-4);
  scene.numerics.step = 0.01;
  const Play play(scene, {[](double /*h*/) { return 0.1; }});
  EXPECT_EQ(play.runs, 1);
  EXPECT_DOUBLE_EQ(play.control.answer().value.restitution, 1.1 * kTrue);
  EXPECT_TRUE(std::isnan(play.control.estimated_error()));
  EXPECT_TRUE(std::isnan(play.control.answer().error.restitution));
}

/// All numbers of an impact are extrapolated alike.
TEST(ErrorControl, GivesEveryNumberAnError) {
  const Play play(scene_with(1e-6), {[](double h) { return h * h; }});
  for (const auto& [name, number] : impact_numbers<Restitution>()) {
    EXPECT_NEAR(play.control.answer().value.*number, kTrue, 1e-6) << name;
    EXPECT_GT(play.control.answer().error.*number, 0.0) << name;
    EXPECT_LT(play.control.answer().error.*number, 1e-6) << name;
  }
}

}  // namespace
}  // namespace impact
