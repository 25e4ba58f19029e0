#include "run/resolution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "expect_input_error.hpp"
#include "mechanics/potential_wall.hpp"
#include "run/make_integrator.hpp"

namespace impact {
namespace {

constexpr int kPoints = 1099;
constexpr double kSoundSpeed = 1.9;
const PotentialWall kWall(300.0, 0.27);

Resolution first(const Scene& scene, const Spectrum& spectrum) {
  return first_resolution(scene, rates(scene, spectrum, kWall, kPoints, kSoundSpeed));
}

double step(const Scene& scene, const Spectrum& spectrum) { return first(scene, spectrum).step; }

Scene scene_with(IntegratorKind integrator, double velocity, double eta) {
  Scene scene;
  scene.numerics.integrator = integrator;
  scene.impact.velocity = velocity;
  scene.material.eta = eta;
  return scene;
}

/// Stable with the wall at its stiffest; and not needlessly short: where accuracy asks for nothing,
/// 0.96 of the limit over that of two runs with steps up to 1.3 times as long each, and the next
/// one below on the scale of methods that solve.
TEST(FirstResolution, StaysBelowTheLimitOfLatticeDampingAndWall) {
  for (const auto integrator :
       {IntegratorKind::kVerlet, IntegratorKind::kBlanesMoan, IntegratorKind::kImplicitDamping,
        IntegratorKind::kExtrapolatedDamping}) {
    for (const Spectrum spectrum : {Spectrum{1e4, 0.0}, Spectrum{1e4, 50.0}, Spectrum{1e4, 1e4}}) {
      for (const double velocity : {1e-4, 0.01, 0.5}) {
        Scene scene = scene_with(integrator, velocity, 0.0);
        scene.numerics.error = 1e-2;
        const double wall = kWall.stiffness(largest_point_force(scene, kPoints, kSoundSpeed));
        const double limit =
            step_limit(integrator, {spectrum.omega_squared + wall * kPoints, spectrum.gamma, 0.0});
        EXPECT_LE(step(scene, spectrum), 0.96 * limit);
        if (velocity < 0.1) {
          const double scale = solves_for_damping(integrator) ? kRefinement : 1.0;
          EXPECT_GE(step(scene, spectrum), std::min(0.1, 0.96 * limit) / (1.69 * scale));
        }
      }
    }
  }
}

/// Small lattices are slow; their step is capped.
TEST(FirstResolution, IsNeverLong) {
  EXPECT_LE(step(scene_with(IntegratorKind::kBlanesMoan, 1e-4, 0.0), {1.0, 0.0}), 0.1);
}

TEST(FirstResolution, TakesAGivenStepUpToTheLimit) {
  Scene scene;
  const Spectrum spectrum{1e4, 0.0};
  scene.numerics.step = 0.01;
  EXPECT_EQ(step(scene, spectrum), 0.01);
  scene.numerics.step = 0.021;
  EXPECT_INPUT_ERROR(step(scene, spectrum),
                     "numerics.step: got 0.021, allowed: at most 0.02 R/c, the stability limit of "
                     "verlet");
  scene.numerics.integrator = IntegratorKind::kBlanesMoan;
  EXPECT_EQ(step(scene, spectrum), 0.021);
}

/// Where the wall, not the lattice, sets the step. A wall along which contacts pass from bond to
/// bond has only methods that hold there.
TEST(FirstResolution, AutoGoesToHigherOrderForSmallErrors) {
  const Spectrum undamped{8100.0, 0.0};
  Scene scene = scene_with(IntegratorKind::kAuto, 0.1, 0.0);
  EXPECT_EQ(first(scene, undamped).integrator, IntegratorKind::kVerlet);
  scene.numerics.error = 1e-8;
  EXPECT_EQ(first(scene, undamped).integrator, IntegratorKind::kTakahashiImada);
  scene.wall.kind = WallKind::kDisk;
  scene.numerics.error = 1e-10;
  EXPECT_EQ(first(scene, undamped).integrator, IntegratorKind::kBlanesMoan);
}

/// Explicit steps where damping leaves them long, implicit ones where it makes them short; both of
/// an impact so fast that the wall allows no steps beyond those of the lattice.
TEST(FirstResolution, AutoGoesToImplicitDampingWhereItIsStiff) {
  const auto integrator = [](double eta) {
    const Scene scene = scene_with(IntegratorKind::kAuto, 0.2, eta);
    return first(scene, {8100.0, 12.4 * eta}).integrator;
  };
  EXPECT_EQ(integrator(1.0), IntegratorKind::kVerlet);
  EXPECT_EQ(integrator(100.0), IntegratorKind::kImplicitDamping);
  EXPECT_EQ(integrator(1e6), IntegratorKind::kImplicitDamping);
}

/// Slow and damped: the factors are earned back, and steps grow as the wall's time does. Where
/// modes may be taken they cost less.
TEST(FirstResolution, AutoGoesToImexWhereADampedImpactIsSlow) {
  const auto resolution = [](double velocity, double eta, bool modal = false) {
    const Scene scene = scene_with(IntegratorKind::kAuto, velocity, eta);
    Rates rates_of_scene = rates(scene, {8100.0, 12.4 * eta}, kWall, kPoints, kSoundSpeed);
    rates_of_scene.time = 0.1 / velocity;
    rates_of_scene.modal = modal;
    return first_resolution(scene, rates_of_scene);
  };
  for (const double eta : {0.1, 10.0, 1e3}) {
    EXPECT_EQ(resolution(1e-4, eta).integrator, IntegratorKind::kImex) << eta;
    EXPECT_EQ(resolution(1e-4, eta, true).integrator, IntegratorKind::kModal) << eta;
    EXPECT_NE(resolution(0.1, eta, true).integrator, IntegratorKind::kModal) << eta;
    EXPECT_NE(resolution(0.3, eta).integrator, IntegratorKind::kImex) << eta;
  }
  EXPECT_NE(resolution(1e-4, 0.0).integrator, IntegratorKind::kImex);
  EXPECT_NEAR(resolution(1e-6, 1.0).step / resolution(1e-5, 1.0).step, 10.0, 0.1);
}

/// Where bonds stiffen, and where it was in vain; and where rounding kicks as hard as the impact,
/// its steps are as short as others.
TEST(FirstResolution, AutoLeavesImexWhereItDoesNotHold) {
  const auto resolution = [](double velocity, double k_b, bool imex) {
    Scene scene = scene_with(IntegratorKind::kAuto, velocity, 1.0);
    scene.material.k_b = k_b;
    Rates rates_of_scene = rates(scene, {8100.0, 12.4}, kWall, kPoints, kSoundSpeed);
    rates_of_scene.time = 0.1 / velocity;
    rates_of_scene.imex = imex;
    rates_of_scene.modal = false;
    return first_resolution(scene, rates_of_scene);
  };
  EXPECT_EQ(resolution(1e-3, 1e-3, true).integrator, IntegratorKind::kImex);
  EXPECT_NE(resolution(1e-3, 1e-3, false).integrator, IntegratorKind::kImex);
  EXPECT_NE(resolution(1e-3, 1e9, true).integrator, IntegratorKind::kImex);
  EXPECT_EQ(resolution(3e-3, 1e-3, true).integrator, IntegratorKind::kImex);
  EXPECT_GT(resolution(1e-6, 1e-3, true).step, 100.0);
  EXPECT_LE(resolution(1e-8, 1e-3, true).step, 0.1);
}

TEST(FirstResolution, TakesAStepOfImexUpToHalfTheRangeOfTheWall) {
  Scene scene = scene_with(IntegratorKind::kImex, 0.01, 1.0);
  scene.numerics.step = 0.16;
  EXPECT_EQ(step(scene, {8100.0, 12.4}), 0.16);
  scene.numerics.step = 0.17;
  EXPECT_INPUT_ERROR(step(scene, {8100.0, 12.4}),
                     "numerics.step: got 0.17, allowed: at most 0.1667 R/c with imex");
}

TEST(FirstResolution, OfAnAdaptiveIntegratorHasItsTolerance) {
  Scene scene = scene_with(IntegratorKind::kBdf, 0.01, 1.0);
  scene.numerics.error = 1e-5;
  EXPECT_EQ(first(scene, {8100.0, 12.4}).tolerance, 1e-5);
  scene.numerics.tolerance = 1e-3;
  EXPECT_EQ(first(scene, {8100.0, 12.4}).tolerance, 1e-3);
}

/// So that runs of different scenes have a factor in common.
TEST(FirstResolution, OfMethodsThatSolveIsOnAScale) {
  const auto resolution = [](IntegratorKind integrator, double velocity, double error) {
    Scene scene = scene_with(integrator, velocity, 100.0);
    scene.numerics.error = error;
    return first(scene, {8100.0, 1240.0});
  };
  for (const auto& [integrator, base] : {std::pair(IntegratorKind::kImplicitDamping, 1.12),
                                         std::pair(IntegratorKind::kExtrapolatedDamping, 1.2)}) {
    for (const double velocity : {0.003, 0.0123, 0.05, 0.2}) {
      for (const double error : {1e-2, 1e-5, 1e-7}) {
        const Resolution last = resolution(integrator, velocity, error);
        const auto runs = leading_up_to(scene_with(integrator, velocity, 100.0), last);
        for (const Resolution& run : runs) {
          const double place = std::log(0.1 / run.step) / std::log(base);
          EXPECT_NEAR(place, std::round(place), 1e-9);
          EXPECT_EQ(run.step, 0.1 * std::pow(base, -std::round(place)));
        }
        EXPECT_GE(runs[1].step / runs[0].step, base * (1.0 - 1e-9));
      }
    }
  }
  EXPECT_EQ(resolution(IntegratorKind::kImplicitDamping, 0.003, 1e-4).step,
            resolution(IntegratorKind::kImplicitDamping, 0.0031, 1e-4).step);
  EXPECT_NE(first(scene_with(IntegratorKind::kVerlet, 0.05, 0.0), {8100.0, 0.0}).step,
            first(scene_with(IntegratorKind::kVerlet, 0.051, 0.0), {8100.0, 0.0}).step);
}

/// The coarsest of the runs of an answer, too, is stable and short enough to show its order; and
/// each is far enough from the next.
TEST(LeadingUpTo, BeginsWithAStepThatIsShortEnough) {
  for (const double omega_squared : {2000.0, 4000.0, 8100.0}) {
    for (const double velocity : {0.001, 0.01, 0.05, 0.3}) {
      for (const double error : {1e-2, 1e-5, 1e-7}) {
        Scene scene = scene_with(IntegratorKind::kVerlet, velocity, 0.0);
        scene.numerics.error = error;
        const auto last = first(scene, {omega_squared, 0.0});
        EXPECT_GE(last.coarsening, 1.12 * (1.0 - 1e-12));
        EXPECT_LE(last.coarsening, 1.3);
        const auto runs = leading_up_to(scene, last);
        ASSERT_EQ(runs.size(), last.leading_runs + 1U);
        double steps = 0.0;
        for (std::size_t k = 0; k < runs.size(); ++k) {
          const double next = k == 0 ? last.step : last.coarsening * runs[k - 1].step;
          EXPECT_DOUBLE_EQ(runs[k].step, next);
          steps += last.step / runs[k].step;
        }
        EXPECT_NEAR(steps_of_all_runs(last), steps, 1e-13);
        EXPECT_LE(runs.back().step,
                  0.96 * step_limit(IntegratorKind::kVerlet, {omega_squared, 0.0}));
        EXPECT_LE(300.0 * velocity * runs.back().step, 0.5 + 1e-12);
      }
    }
  }
}

TEST(LeadingUpTo, DividesTheIntervalBetweenResets) {
  Scene scene;
  scene.wall.kind = WallKind::kLattice;
  const auto runs = leading_up_to(scene, {IntegratorKind::kVerlet, 0.002});
  ASSERT_EQ(runs.size(), 3);
  EXPECT_DOUBLE_EQ(runs[2].step, 0.002);
  EXPECT_DOUBLE_EQ(runs[1].step, 0.004 / 3.0);
  EXPECT_DOUBLE_EQ(runs[0].step, 0.001);
}

/// These two may bear each other out.
TEST(LeadingUpTo, IsOneRunWhereItsStepIsHalved) {
  Scene scene;
  scene.wall.kind = WallKind::kLattice;
  const auto runs = leading_up_to(scene, {IntegratorKind::kVerlet, 0.004});
  ASSERT_EQ(runs.size(), 2);
  EXPECT_DOUBLE_EQ(runs[1].step, 0.004);
  EXPECT_DOUBLE_EQ(runs[0].step, 0.002);
}

TEST(LeadingUpTo, TightensTolerances) {
  const auto runs = leading_up_to(Scene{}, {IntegratorKind::kRk8pd, 0.02, 1e-6});
  EXPECT_GT(runs[2].tolerance, 2.0 * runs[1].tolerance);
  EXPECT_GT(runs[1].tolerance, 2.0 * runs[0].tolerance);
  EXPECT_EQ(runs[0].tolerance, 1e-6);
}

/// The longest that divides the interval and is not above the wanted step.
TEST(FirstResolution, DividesTheIntervalBetweenResets) {
  const Spectrum spectrum{1e4, 0.0};
  Scene scene;
  scene.wall.kind = WallKind::kLattice;
  scene.wall.boundary = Boundary::kFixed;
  const double automatic = step(scene, spectrum);
  scene.wall.boundary = Boundary::kReset;
  const auto step_for = [&](double interval) {
    scene.wall.reset_interval = interval;
    return step(scene, spectrum);
  };
  EXPECT_DOUBLE_EQ(step_for(automatic), automatic);
  EXPECT_DOUBLE_EQ(step_for(3.0 * automatic), automatic);
  EXPECT_DOUBLE_EQ(step_for(1.01 * automatic), 0.505 * automatic);
  EXPECT_DOUBLE_EQ(step_for(0.3 * automatic), 0.3 * automatic);
  // One part in 65,000 of so many steps.
  EXPECT_NEAR(step_for(1000.0), automatic, 2e-5 * automatic);
  scene.numerics.step = 0.003;
  EXPECT_DOUBLE_EQ(step_for(0.004), 0.002);
  EXPECT_DOUBLE_EQ(step_for(0.001), 0.001);
  EXPECT_DOUBLE_EQ(step_for(0.009), 0.003);
}

TEST(Finer, ShortensTheStepByTheFactorAtLeast) {
  const Resolution coarse{IntegratorKind::kVerlet, 0.02, 0.0};
  EXPECT_DOUBLE_EQ(finer(Scene{}, coarse, 1.5).step, 0.02 / 1.5);
  Scene scene;
  scene.wall.kind = WallKind::kLattice;  // resets every 0.004 R/c
  EXPECT_EQ(finer(scene, {IntegratorKind::kVerlet, 0.004, 0.0}, 1.5).step, 0.002);
}

TEST(Finer, TightensATolerance) {
  const Resolution coarse{IntegratorKind::kBdf, 0.02, 1e-4};
  EXPECT_DOUBLE_EQ(finer(Scene{}, coarse, 10.0).tolerance, 1e-8);
  EXPECT_EQ(finer(Scene{}, coarse, 10.0).step, 0.02);
}

}  // namespace
}  // namespace impact
