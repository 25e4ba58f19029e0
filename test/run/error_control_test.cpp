#include "run/error_control.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "measure/strain.hpp"
#include "mechanics/motion.hpp"
#include "run/make_integrator.hpp"

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

/// Of so many points that the wall is not hard over their spacing.
Scene many_points(double error) {
  Scene scene = scene_with(error);
  scene.disk.recipe.points = 1099;
  return scene;
}

/// A made-up method: what e and its tail come to with a step.
struct Method {
  /// Relative. The root of a tolerance stands for a step.
  std::function<double(double)> error = [](double /*step*/) { return 0.0; };
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
      const Resolution& resolution = control.resolution();
      const bool adaptive = is_adaptive(resolution.integrator);
      const double e =
          kTrue * (1.0 + method.error(adaptive ? std::sqrt(resolution.tolerance) : run.step));
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

/// Four where three would need a much shorter step for as good an answer.
TEST(ErrorControl, ComparesThreeOrFourRunsEachFinerThanTheLast) {
  for (const double error : {1e-4, 1e-6}) {
    const Play play(scene_with(error), {});
    EXPECT_EQ(play.runs, error < 1e-5 ? 4 : 3);
    const double factor = play.steps[0] / play.steps[1];
    EXPECT_GE(factor, 1.12 * (1.0 - 1e-12));
    EXPECT_LE(factor, 1.3);
    for (std::size_t k = 2; k < play.steps.size(); ++k) {
      EXPECT_DOUBLE_EQ(play.steps[k - 1] / play.steps[k], factor);
    }
  }
}

/// On a wall whose velocities are reset every 0.004 R/c.
Scene on_absorbing_wall(double error) {
  Scene scene = scene_with(error);
  scene.wall.kind = WallKind::kLattice;
  scene.wall.points = 70;
  return scene;
}

/// Steps of 0.004 and 0.002 R/c: a difference of 3/4 of the longer one's error.
TEST(ErrorControl, TakesTwoRunsWhereTheSecondHalvesTheStep) {
  for (const double difference : {0.019, 0.021}) {
    const double first_error = difference * 1e-4 * 4.0 / 3.0;
    const Method method{[=](double h) { return first_error * std::pow(h / 0.004, 2); }};
    const Play play(on_absorbing_wall(1e-4), method);
    EXPECT_EQ(play.steps[0], 0.004);
    EXPECT_EQ(play.steps[1], 0.002);
    EXPECT_EQ(play.runs, difference < 0.02 ? 2 : 3);
    EXPECT_LT(play.true_error(), play.control.estimated_error());
    if (play.runs > 2) continue;
    EXPECT_NEAR(play.control.estimated_error(), difference * 1e-4, 1e-3 * difference * 1e-4);
  }
}

TEST(ErrorControl, TakesMoreThanTwoRunsWhereContactsHop) {
  const Method hops{[](double /*step*/) { return 0.0; },
                    [](FinishedImpact& run) { run.error_by_hops = 2e-4; }};
  EXPECT_GT(Play(on_absorbing_wall(1e-4), hops).runs, 2);
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

/// Limits that agree by chance: the fifth run shows that they were off by 10⁻³ of what was
/// extrapolated.
TEST(ErrorControl, AsksTwiceWhereMuchIsExtrapolated) {
  const Scene scene = scene_with(1e-8);
  int run = 0;
  const Play play(scene, {[&](double h) { return h * h * (++run > 4 ? 1.0 : 1.001); }});
  EXPECT_GT(play.runs, 5);
  EXPECT_LE(play.true_error(), 1e-8);
  const Play exact(scene, {[](double h) { return h * h; }});
  EXPECT_EQ(exact.runs, 5);
}

/// Where the term in h⁴ takes away what the next one does at the steps of three runs, they look
/// like pure h², and their limit is off by that next term: here that of a vibration against the
/// wall.
TEST(ErrorControl, AsksOnceMoreWhereTheStepsAreLongForTheWall) {
  constexpr double kSize = 1e-2;
  const Scene scene = many_points(1e-4);
  const std::vector<double> steps = Play(scene, {}).steps;
  const double omega = 1.5 / steps.front();
  const auto squared = [omega](double h) { return std::pow(omega * h, 2); };
  double sum = 0.0;
  for (const double h : steps) sum += squared(h);
  const auto play = [&](double rate) {
    return Play(scene, {[&](double h) {
                          const double x = squared(h);
                          return kSize * x * (1.0 - sum * x / 60.0 + x * x / 60.0);
                        },
                        [rate](FinishedImpact& run) { run.stiffest_contact = rate; }});
  };
  const Play soft = play(0.0);
  EXPECT_EQ(soft.runs, 3);
  EXPECT_GT(soft.true_error(), 1e-4);
  const Play stiff = play(omega * omega);
  EXPECT_GT(stiff.runs, 3);
  EXPECT_LE(stiff.true_error(), 1e-4);
}

/// Points that meet a hard wall one after another do not err by one curve: where three limits take
/// out more than the wanted error, a fourth run is asked for, however near they are.
TEST(ErrorControl, AsksOnceMoreWhereTheWallIsHardOverTheSpacing) {
  const Method squared{[](double h) { return h * h; }};
  const Play soft(many_points(1e-4), squared);
  EXPECT_EQ(soft.runs, 3);
  EXPECT_GT(std::pow(soft.steps.back(), 2), 1e-4);
  const Play hard(scene_with(1e-4), squared);
  EXPECT_EQ(hard.runs, 4);
  EXPECT_GT(std::pow(hard.steps[2], 2), 1e-4);
}

/// The extrapolated answer needs steps that leave one run by itself with a hundred times the error.
TEST(ErrorControl, ExtrapolatesWhereTheOrderIsSeen) {
  const auto error = [](double h) { return 0.06 * h * h * (1.0 + h * h); };
  const Play play(scene_with(1e-6), {error});
  EXPECT_EQ(play.runs, 4);
  const double of_run = error(play.steps.back());
  EXPECT_GT(of_run, 20e-6);
  EXPECT_LT(play.true_error(), 1e-6);
  EXPECT_NEAR(play.control.answer().error_of_run, kTrue * of_run, 0.01 * of_run);
  const ImpactAnswer& answer = play.control.answer();
  const double of_finest = kTrue * (1.0 + of_run);
  EXPECT_NEAR(answer.error_of_run,
              std::abs(of_finest - answer.value.restitution) + answer.error.restitution, 1e-15);
}

/// Where forces act at the start, Takahashi–Imada is named in vain: its order is not there.
TEST(ErrorControl, LooksForNoOrderOfTakahashiImadaUnderForces) {
  const auto is_extrapolated = [](const std::function<void(Scene&)>& change) {
    const auto error = [](double h) { return std::pow(h, 4); };
    Scene scene = scene_with(1e-5, IntegratorKind::kTakahashiImada);
    change(scene);
    const Play play(scene, {error});
    return play.control.answer().value.restitution != kTrue * (1.0 + error(play.steps.back()));
  };
  EXPECT_TRUE(is_extrapolated([](Scene& /*scene*/) {}));
  EXPECT_FALSE(is_extrapolated([](Scene& scene) { scene.gravity = 0.01; }));
  EXPECT_FALSE(is_extrapolated([](Scene& scene) { scene.impact.spin = 0.1; }));
  EXPECT_FALSE(is_extrapolated([](Scene& scene) { scene.impact.gap = 0.01; }));
}

/// The part of h⁴ in a limit that three runs at these steps, from coarse to fine, are in doubt of.
double doubt_of_limit(const std::vector<double>& steps) {
  std::vector<Sample> runs;
  for (const double h : steps) runs.push_back({h, std::pow(h, 4)});
  return extrapolated(runs[0], runs[1], runs[2], 2).error;
}

/// A h² + B h⁴ with a limit that is in doubt by this much after three runs, and exact.
Method with_doubt(double doubt, const Scene& scene) {
  const Play exact(scene, {});
  const double b = doubt / doubt_of_limit(exact.steps);
  const double a = 1e3 * b * exact.steps.back() * exact.steps.back();
  return {[a, b](double h) { return h * h * (a + b * h * h); }};
}

/// A limit of three runs alone is taken up to a tenth of the wanted error.
TEST(ErrorControl, ConfirmsALimitByAFourthRun) {
  const Scene scene = many_points(1e-4);
  for (const double share : {0.05, 0.5}) {
    const Play play(scene, with_doubt(share * 1e-4, scene));
    EXPECT_EQ(play.runs, share < 0.1 ? 3 : 4);
    EXPECT_LT(play.true_error(), 1e-4 * 1e-3);  // rounding
  }
}

/// The doubt of a limit goes with h⁴: a sixteenth of 20 times the wanted error at 0.4 of the step.
TEST(ErrorControl, RefinesByThePowerThatIsLeft) {
  const Scene scene = scene_with(1e-4);
  const Play play(scene, with_doubt(20e-4, scene));
  const double factor = std::pow(2.0 * 20.0, 1.0 / 4.0);
  EXPECT_NEAR(play.steps[2] / play.steps[3], factor, 0.05 * factor);
}

/// Where a point crosses the wall's range in two steps, agreement with an order is chance.
TEST(ErrorControl, SeesNoOrderInStepsTooLongForTheWall) {
  const auto error = [](double h) { return 1e3 * std::pow(h, 6); };
  for (const double a : {300.0, 140.0, 100.0}) {
    Scene scene = scene_with(1e-2, IntegratorKind::kBlanesMoan);
    scene.wall.a = a;
    const Play play(scene, {error});
    const bool too_long = a * scene.impact.velocity * play.steps.front() > 0.5;
    EXPECT_EQ(too_long, a >= 140.0);
    const double of_run = kTrue * (1.0 + error(play.steps.back()));
    EXPECT_EQ(play.control.answer().value.restitution == of_run, too_long);
  }
}

/// The tolerance of an adaptive integrator says nothing of an order, whatever the runs show: three
/// times their range.
TEST(ErrorControl, SeesNoOrderInTolerances) {
  const auto error = [](double h) { return 0.05 * h * h; };
  const Play play(scene_with(1e-4, IntegratorKind::kBdf), {error});
  EXPECT_EQ(play.runs, 3);
  const double finest = std::sqrt(play.control.resolution().tolerance);
  EXPECT_DOUBLE_EQ(play.control.answer().value.restitution, kTrue * (1.0 + error(finest)));
  const double range = error(finest * std::pow(kRefinement, kToleranceOrder)) - error(finest);
  EXPECT_NEAR(play.control.estimated_error(), 3.0 * range, 1e-3 * range);
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

/// Of five runs the range falls by a quarter and by a third in turn: the quarters alone would be
/// too little to go on.
TEST(ErrorControl, GoesOnWhileTheErrorFallsNowAndThen) {
  int runs = 0;
  const Method method{[&runs](double /*h*/) {
                        const double size = 2.6e-3 * std::pow(0.5, runs / 2);
                        return ++runs % 2 == 0 ? size : -size;
                      },
                      [](FinishedImpact& run) { run.folded = true; }};
  const Play play(scene_with(1e-3), method);
  EXPECT_GE(play.runs, 5 + 2 * 4);
  EXPECT_LE(play.true_error(), 1e-3);
}

/// What the method before it left is no measure for one of higher order: its first five runs
/// disagree as much, all others are exact.
TEST(ErrorControl, BeginsAnewWithAMethodOfHigherOrder) {
  int of_other = 0;
  int runs = 0;
  double last = 1.0;
  const auto error = [&](double h) {
    const bool is_other = of_other > 0 || h > 1.01 * last;
    last = h;
    if (is_other && ++of_other > 5) return 0.0;
    return ++runs % 2 == 0 ? 1e-3 : -1e-3;
  };
  const Play play(scene_with(1e-4, IntegratorKind::kAuto),
                  {error, [](FinishedImpact& run) { run.folded = true; }});
  EXPECT_EQ(play.control.resolution().integrator, IntegratorKind::kBlanesMoan);
  EXPECT_GE(of_other, 10);
  EXPECT_LE(play.true_error(), 1e-4);
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
  for (const auto& [method, too_near] : {std::pair(folding, 1), std::pair(cut_off, 0)}) {
    const Play play(scene_with(1e-4), method);
    EXPECT_EQ(play.runs - too_near, 5);
    const double finest = play.steps.back();
    EXPECT_DOUBLE_EQ(play.control.answer().value.restitution,
                     kTrue * (1.0 + 1e-3 * finest * finest));
  }
}

/// A fold may turn on what the wall holds at the start: there all begin 10⁴ times as far out,
/// unless the gap is given.
TEST(ErrorControl, StartsHigherWhereTheLatticeFolds) {
  const Method folding{{[](double h) { return 1e-3 * h * h; }},
                       [](FinishedImpact& run) { run.folded = true; }};
  Scene scene = scene_with(1e-4);
  EXPECT_NEAR(Play(scene, folding).control.resolution().lift, std::log(1e4) / scene.wall.a, 1e-12);
  scene.impact.gap = 0.1;
  EXPECT_EQ(Play(scene, folding).control.resolution().lift, 0.0);
}

/// Five that fold and yet come nearer to each other as order 6 lets them: in doubt by 12 times the
/// error of the finest, of which their range is 230.
TEST(ErrorControl, TrustsRunsThatFoldIfAllOfThemFall) {
  const auto error = [](double h) { return 1e-6 * std::pow(h / 0.02, 6); };
  const Method folding{error, [](FinishedImpact& run) { run.folded = true; }};
  const Play play(scene_with(1e-2, IntegratorKind::kBlanesMoan), folding);
  ASSERT_EQ(play.runs, 1 + 5);
  EXPECT_GT(play.control.estimated_error(), error(play.steps.back()));
  EXPECT_LT(play.control.estimated_error(), 20.0 * error(play.steps.back()));
}

/// Powers that cancel in part, so that three runs do not show the order: a fourth near them does,
/// where their differences alone would ask for steps half as long.
TEST(ErrorControl, AsksForARunNearbyWhereItMayShowTheOrder) {
  const auto error = [](double h) {
    const double x = h / 0.02;
    return 1e-3 * (x * x - 0.06 * std::pow(x, 4));
  };
  const Play play(scene_with(1e-4), {error});
  ASSERT_EQ(play.runs, 4);
  EXPECT_NEAR(play.steps[2] / play.steps[3], 1.2, 1e-12);
  EXPECT_LE(play.true_error(), play.control.estimated_error());
}

/// What happened in one run can happen in the others, even if it was not seen there.
TEST(ErrorControl, RemembersTheIrregularitiesOfOneRun) {
  const auto error = [](double h) { return 1e-3 * h * h; };
  int runs = 0;
  const Method folds_once{error, [&runs](FinishedImpact& run) { run.folded = ++runs == 1; }};
  EXPECT_EQ(Play(scene_with(1e-4), folds_once).runs, 1 + 5);
  runs = 0;
  const Method hops_once{
      error, [&runs](FinishedImpact& run) { run.error_by_hops = ++runs == 1 ? 1e-3 : 0.0; }};
  const Play play(scene_with(1e-4), hops_once);
  EXPECT_DOUBLE_EQ(play.control.answer().value.restitution,
                   kTrue * (1.0 + error(play.steps.back())));
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
                      [tail](FinishedImpact& run) {
                        run.tail_error = tail;
                        run.measured.peak_force = 1e-3;
                      }};
  const Play play(scene_with(1e-4), method);
  EXPECT_GE(play.control.estimated_error(), tail);
  EXPECT_GE(play.control.answer().error.impulse, tail * kTrue);
  // Rounding is below 10⁻¹² of each number.
  EXPECT_NEAR(play.control.answer().error.peak_force, tail * 1e-3, 1e-12 * 1e-3);
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
  run.tail_error = 1e-4;
  ASSERT_FALSE(control.accepts(run));
  EXPECT_NEAR(std::exp(-scene.wall.a * control.resolution().lift),
              0.5 * 1e-5 / 1e-3 * 0.5 * 1e-5 / 1e-4, 1e-8);
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
    EXPECT_EQ(play.runs, 4);
    EXPECT_LE(play.true_error(), play.control.estimated_error());
    EXPECT_GE(play.control.estimated_error(), 16.0 * 2.2e-16 * std::sqrt(10.0 / 0.02));
  }
}

/// Solutions for the damped velocities are off to one side, so that their rounding adds up.
TEST(ErrorControl, AddsUpTheRoundingOfDampedSteps) {
  Scene scene = scene_with(1e-10, IntegratorKind::kImplicitDamping);
  scene.material.eta = 10.0;
  const Play play(scene, {});
  EXPECT_GE(play.control.estimated_error(), 16.0 * 2.2e-16 * std::floor(10.0 / play.steps.back()));
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

/// At its start the wall holds a little energy. A motion whose step is a little too long at once
/// has it halved. It is not the wall's fault, so the next steps are shorter than that.
TEST(ErrorControl, SeesThatTheStepOfARunWasReduced) {
  const Scene scene = scene_with(1e-4);
  const auto composition = compose_shared(scene);
  ErrorControl control(scene, *composition);
  Resolution too_long = control.resolution();
  too_long.step =
      1.5 * step_limit(IntegratorKind::kVerlet, {composition->rates.lattice.omega_squared, 0.0});
  impact::Run run(scene, composition, too_long);
  run.advance();
  ASSERT_EQ(run.system().halvings(), 1);
  Restitution measured;
  measured.velocity_after = 0.04;
  EXPECT_FALSE(control.accepts(run, measured));
  EXPECT_LE(control.resolution().step, run.system().step_size() / kRefinement);
  EXPECT_TRUE(control.later_resolutions().empty());
}

/// The stiffer the wall was, the shorter the next steps; not by how often steps were halved. What
/// is tried in vain three times is given up for half the step.
TEST(ErrorControl, PlansByTheStiffnessThatWasMet) {
  const Scene scene = scene_with(1e-4, IntegratorKind::kVerlet);
  const auto composition = compose_shared(scene);
  ErrorControl control(scene, *composition);
  const Spectrum lattice = composition->rates.lattice;
  const double inner_share = Motion::inner_share(scene.wall.a, composition->rates.spacing);
  FinishedImpact run;
  run.step_reduced = true;
  run.time = 10.0;
  for (const double times : {40.0, 60.0, 80.0}) {
    run.stiffest_contact = times * lattice.omega_squared;
    run.step = 0.5 * control.resolution().step;
    ASSERT_FALSE(control.accepts(run));
    const double limit =
        step_limit(IntegratorKind::kVerlet, lattice, run.stiffest_contact, inner_share);
    EXPECT_LE(control.resolution().step, 0.96 * limit);
    EXPECT_GE(control.resolution().step, 0.9 * limit);
  }
  run.stiffest_contact = 100.0 * lattice.omega_squared;
  run.step = 0.5 * control.resolution().step;
  ASSERT_FALSE(control.accepts(run));
  EXPECT_LE(control.resolution().step, run.step / kRefinement);
}

/// What the contact holds at the end becomes motion. Runs at their start stand for those at their
/// end.
struct EndedEarly {
  explicit EndedEarly(const Scene& scene) {
    const auto composition = compose_shared(scene);
    ErrorControl control(scene, *composition);
    Restitution measured;
    measured.velocity_before = -0.05;
    measured.tangential_velocity_before = 0.0;
    measured.spin_before = 0.0;
    measured.moment_of_inertia = 0.5;
    measured.energy_before = 0.5 * 0.05 * 0.05;
    measured.velocity_after = 0.04;
    measured.energy_restitution = 0.85;
    measured.impulse = 0.09;
    for (bool accepted = false; !accepted;) {
      const impact::Run run(scene, composition, control.resolution());
      energy = run.system().field().wall_potential_energy(run.state().position);
      accepted = control.accepts(run, measured);
    }
    answer = control.answer().value;
  }

  Restitution answer;
  double energy = 0.0;
};

/// v″² = v′² + 2U.
TEST(ErrorControl, CountsWhatTheWallStillHoldsAsVelocity) {
  Scene scene = scene_with(1e-2);
  scene.impact.gap = 0.0537;
  const auto [answer, energy] = EndedEarly(scene);
  ASSERT_GT(energy, 3e-4 * 0.04 * 0.04);
  const double after = std::sqrt(0.04 * 0.04 + 2.0 * energy);
  // To the first order of U/v′², the square of which is below 10⁻⁶.
  EXPECT_NEAR(answer.velocity_after, after, 1e-6 * after);
  EXPECT_NEAR(answer.restitution, after / 0.05, 1e-6);
  EXPECT_NEAR(answer.impulse, 0.05 + after, 1e-6 * after);
  EXPECT_NEAR(std::pow(answer.energy_restitution, 2), 0.85 * 0.85 + 2.0 * energy / (0.05 * 0.05),
              1e-12);
}

/// Of U a disk of 1 M gets the part that the mass m of the other one is of both, μ = m/(1 + m):
/// v″² = v′² + 2μU.
TEST(ErrorControl, SharesWhatDisksStillHold) {
  Scene scene = scene_with(1e-2);
  scene.impact.gap = 0.0498;
  scene.wall.kind = WallKind::kDisk;
  scene.wall.radius = 2.0;
  const auto [answer, energy] = EndedEarly(scene);
  ASSERT_GT(energy, 3e-4 * 0.04 * 0.04);
  ASSERT_LT(energy, 1e-3 * 0.04 * 0.04);
  const double after = std::sqrt(0.04 * 0.04 + 2.0 * 0.8 * energy);
  EXPECT_NEAR(answer.velocity_after, after, 1e-6 * after);
  EXPECT_NEAR(answer.impulse, 0.05 + after, 1e-6 * after);
}

/// Along y the gap is continuous, and no energy hops; but the force turns.
TEST(ErrorControl, CountsForcesThatTurnAtAHop) {
  Scene scene = scene_with(1e-1);
  scene.seed = 3;
  scene.wall.kind = WallKind::kLattice;
  scene.wall.boundary = Boundary::kFixed;
  scene.wall.gap = GapMeasure::kVertical;
  scene.wall.points = 200;
  scene.wall.width = 3.0;
  scene.wall.height = 0.5;
  const auto composition = compose_shared(scene);
  ErrorControl control(scene, *composition);
  impact::Run run(scene, composition, control.resolution());
  while (!run.finished()) run.advance();
  const SurfaceContact& wall = *run.system().field().elastic_wall;
  ASSERT_GT(wall.turned(), 3.0 * wall.hops_size());
  Restitution measured;
  measured.velocity_before = -0.05;
  measured.velocity_after = 0.04;
  while (!control.accepts(run, measured)) {
  }
  const double way = scene.wall.a * 0.05 * run.system().step_size();
  EXPECT_GE(control.estimated_error(), wall.turned() / (0.04 * 0.04) * std::min(1.0, way));
}

/// After a run that broke off all begin anew at half the step, four times.
TEST(ErrorControl, GoesOnAfterRunsThatBrokeOff) {
  const Scene scene = scene_with(1e-4);
  ErrorControl control(scene, compose(scene));
  FinishedImpact run;
  run.measured.velocity_after = 0.04;
  EXPECT_FALSE(control.accepts(run));
  for (int failures = 0; failures < 4; ++failures) {
    const double step = control.resolution().step;
    control.take_failure(RunFailure("broke off"));
    EXPECT_LE(control.resolution().step, 0.5 * step * (1.0 + 1e-12));
    EXPECT_TRUE(control.later_resolutions().empty());
    EXPECT_FALSE(control.accepts(run));
    EXPECT_FALSE(control.accepts(run));
  }
  EXPECT_THROW(control.take_failure(RunFailure("broke off")), RunFailure);
}

Scene slow_and_damped() {
  Scene scene = scene_with(1e-4, IntegratorKind::kAuto);
  scene.impact.velocity = 1e-3;
  scene.material.eta = 1.0;
  return scene;
}

/// Where `auto` began with implicit bonds, what fails is no fault of short steps.
TEST(ErrorControl, GoesOnWithOtherMethodsWhereImexBreaksOff) {
  const Scene scene = slow_and_damped();
  ErrorControl control(scene, compose(scene));
  ASSERT_EQ(control.resolution().integrator, IntegratorKind::kImex);
  control.take_failure(RunFailure("broke off"));
  EXPECT_EQ(control.resolution().integrator, IntegratorKind::kVerlet);
  EXPECT_EQ(control.later_resolutions().size(), 2U);
  for (int failures = 0; failures < 4; ++failures) {
    control.take_failure(RunFailure("broke off"));
    EXPECT_EQ(control.resolution().integrator, IntegratorKind::kVerlet);
  }
  EXPECT_THROW(control.take_failure(RunFailure("broke off")), RunFailure);
}

TEST(ErrorControl, StaysWithImexWhereTheOthersTakeTooLong) {
  Scene scene = slow_and_damped();
  scene.impact.velocity = 1e-5;
  scene.numerics.longest = 0.05;
  ErrorControl control(scene, compose(scene));
  for (int failures = 0; failures < 4; ++failures) {
    control.take_failure(RunFailure("broke off"));
    EXPECT_EQ(control.resolution().integrator, IntegratorKind::kImex);
  }
  EXPECT_THROW(control.take_failure(RunFailure("broke off")), RunFailure);
}

/// Runs by imex that agree on nothing are no answer, and no reason to give up.
TEST(ErrorControl, GoesOnWithOtherMethodsWhereImexDoesNotConverge) {
  const Scene scene = slow_and_damped();
  double imex = 0.0;
  const double longest = compose(scene).resolution.step;
  const Play play(scene, {[&](double h) {
                    const bool is_imex = h > 0.1 * longest;
                    return is_imex ? 1e-2 * std::sin(++imex * 2.4) : 0.0;
                  }});
  EXPECT_NE(play.control.resolution().integrator, IntegratorKind::kImex);
  EXPECT_GE(imex, 3.0);
  EXPECT_LE(play.true_error(), 1e-4);
}

TEST(ErrorControl, LeavesTheFailureOfAGivenStep) {
  Scene scene = scene_with(1e-4);
  scene.numerics.step = 0.01;
  ErrorControl control(scene, compose(scene));
  EXPECT_THROW(control.take_failure(RunFailure("broke off")), RunFailure);
}

Scene small_contact() {
  Scene scene = scene_with(1e-4, IntegratorKind::kAuto);
  scene.kind = SceneKind::kContact;
  return scene;
}

/// Positions are rounded, by up to 4 ε R in all: that is much of the strain under a light load.
TEST(ErrorControl, CountsTheRoundingOfAContact) {
  Scene scene = small_contact();
  scene.load.p = 1e-7;
  impact::Run run(scene);
  while (!run.finished()) run.advance();
  ErrorControl control(scene, compose(scene));
  ASSERT_TRUE(control.accepts(run, {}));
  const double strain =
      StrainMeter(run.lattice().points).measure(run.disk_state().position).strain();
  EXPECT_GE(control.estimated_error(), 0.99 * 4.0 * 2.2e-16 / strain);
  EXPECT_LT(control.estimated_error(), 4.0 * 4.0 * 2.2e-16 / strain);
}

TEST(ErrorControl, GivesUpAContactThatDidNotComeToRest) {
  Scene scene = small_contact();
  scene.numerics.integrator = IntegratorKind::kImplicitDamping;
  scene.material.eta = 100.0;
  Composition composition = compose(scene);
  composition.expected_time = 0.01;
  ErrorControl control(scene, composition);
  impact::Run run(scene, std::make_shared<const Composition>(std::move(composition)));
  while (!run.finished()) run.advance();
  ASSERT_TRUE(run.has_flag(Flag::kNotAtRest));
  try {
    control.accepts(run, {});
    ADD_FAILURE() << "taken as an answer";
  } catch (const RunFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("no state of rest"), std::string::npos);
  }
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

/// All numbers of an impact are extrapolated alike, except those that are read off the steps: they
/// are those of the last run, in doubt by the range of all.
/// It is not known when the spin is read, but that calls for no more runs. Not more than what is
/// not seen of the energy can have been in it.
TEST(ErrorControl, CountsWhatDampingTakesOfTheSpin) {
  for (const double lost : {0.5, std::numeric_limits<double>::infinity()}) {
    const Method slows{[](double /*step*/) { return 0.0; },
                       [=](FinishedImpact& run) {
                         run.lost_of_spin = lost;
                         run.measured.tangential_velocity_before = 0.3;
                         run.measured.spin_before = -0.1;
                         run.measured.normal_energy = 0.3;
                         run.measured.tangential_energy = 0.2;
                         run.measured.rotation_energy = 0.1;
                         run.measured.moment_of_inertia = 0.5;
                         run.measured.energy_before = 0.25 * kTrue * kTrue / 0.1;
                       }};
    const Play play(scene_with(1e-4), slows);
    EXPECT_EQ(play.runs, 3);
    EXPECT_LT(play.control.estimated_error(), 1e-6);
    const Restitution& error = play.control.answer().error;
    const double energy = std::isfinite(lost) ? 0.1 * (1.5 * 1.5 - 1.0) : 0.4;
    const double spin = kTrue * (std::sqrt(1.0 + energy / 0.1) - 1.0);
    EXPECT_NEAR(error.spin_after, spin, 1e-6);
    EXPECT_NEAR(error.tangential_restitution, spin / 0.2, 1e-6);
    EXPECT_NEAR(error.rotation_energy, energy, 1e-6);
    EXPECT_NEAR(error.energy_restitution, 0.5 * energy / kTrue, 1e-6);
    EXPECT_LT(error.restitution, 1e-6);
    EXPECT_GE(error.wall_spin_after, std::min(lost, 1.0) * kTrue);
  }
}

TEST(ErrorControl, GivesEveryNumberAnError) {
  const auto error = [](double h) { return h * h; };
  const Play play(scene_with(1e-6), {error});
  const double of_run = error(play.steps.back());
  for (const auto& [name, number] : impact_numbers<Restitution>()) {
    const bool is_read = is_read_off_steps(name);
    EXPECT_NEAR(play.control.answer().value.*number, kTrue * (1.0 + (is_read ? of_run : 0.0)), 1e-6)
        << name;
    EXPECT_GT(play.control.answer().error.*number, is_read ? kTrue * of_run : 0.0) << name;
    EXPECT_LT(play.control.answer().error.*number, is_read ? 10.0 * kTrue * of_run : 1e-6) << name;
  }
}

}  // namespace
}  // namespace impact
