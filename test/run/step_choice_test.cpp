#include "run/step_choice.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "expect_input_error.hpp"
#include "mechanics/velocity_verlet.hpp"

namespace impact {
namespace {

constexpr int kPoints = 1099;
constexpr double kSoundSpeed = 1.9;
const PotentialWall kWall(300.0, 0.27);

double step(const Scene& scene, const Spectrum& spectrum) {
  return choose_step(scene, spectrum, kWall, kPoints, kSoundSpeed);
}

TEST(RoundDownTo125, FindsTheNearestBelow) {
  EXPECT_EQ(round_down_to_125(0.0099), 0.005);
  EXPECT_EQ(round_down_to_125(0.01), 0.01);
  EXPECT_EQ(round_down_to_125(0.19), 0.1);
  EXPECT_EQ(round_down_to_125(0.0021), 0.002);
  EXPECT_EQ(round_down_to_125(7.0), 5.0);
}

TEST(ChooseStep, StaysBelowTheLimitOfLatticeDampingAndWall) {
  Scene scene;
  for (const Spectrum spectrum : {Spectrum{1e4, 0.0}, Spectrum{1e4, 50.0}, Spectrum{1e4, 1e4}}) {
    for (const double velocity : {1e-4, 0.01, 0.5}) {
      scene.impact.velocity = velocity;
      const double wall = kWall.stiffness(largest_point_force(scene, kPoints, kSoundSpeed));
      const double limit =
          VelocityVerlet().step_limit(spectrum.omega_squared + wall * kPoints, spectrum.gamma);
      EXPECT_LE(step(scene, spectrum), 0.9 * limit);
      EXPECT_GE(step(scene, spectrum), 0.15 * limit);
    }
  }
}

/// Small lattices are slow; their step is capped.
TEST(ChooseStep, IsNeverLong) { EXPECT_EQ(step(Scene{}, {1.0, 0.0}), 0.02); }

TEST(ChooseStep, TakesAGivenStepUpToTheLimit) {
  Scene scene;
  const Spectrum spectrum{1e4, 0.0};
  scene.numerics.step = 0.01;
  EXPECT_EQ(step(scene, spectrum), 0.01);
  scene.numerics.step = 0.021;
  EXPECT_INPUT_ERROR(step(scene, spectrum),
                     "numerics.step: got 0.021, allowed: at most 0.02 R/c, the stability limit");
}

/// The longest that divides the interval and is not above the wanted step.
TEST(ChooseStep, DividesTheIntervalBetweenResets) {
  const Spectrum spectrum{1e4, 0.0};
  Scene scene;
  scene.wall.kind = WallKind::kLattice;
  const double automatic = 0.005;
  scene.wall.boundary = Boundary::kFixed;
  ASSERT_EQ(step(scene, spectrum), automatic);
  scene.wall.boundary = Boundary::kReset;
  const auto step_for = [&](double interval) {
    scene.wall.reset_interval = interval;
    return step(scene, spectrum);
  };
  EXPECT_DOUBLE_EQ(step_for(automatic), automatic);
  EXPECT_DOUBLE_EQ(step_for(3.0 * automatic), automatic);
  EXPECT_DOUBLE_EQ(step_for(1.01 * automatic), 0.505 * automatic);
  EXPECT_DOUBLE_EQ(step_for(0.3 * automatic), 0.3 * automatic);
  EXPECT_DOUBLE_EQ(step_for(1000.0), automatic);
  scene.numerics.step = 0.003;
  EXPECT_DOUBLE_EQ(step_for(0.004), 0.002);
  EXPECT_DOUBLE_EQ(step_for(0.001), 0.001);
  EXPECT_DOUBLE_EQ(step_for(0.009), 0.003);
}

/// Two points that push each other have half the mass of one.
TEST(ChooseStep, CountsBothEndsOfAContact) {
  Scene scene;
  scene.wall.boundary = Boundary::kFixed;
  int shorter = 0;
  for (const double velocity : {0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}) {
    scene.impact.velocity = velocity;
    scene.wall.kind = WallKind::kPotential;
    const double one_end = step(scene, {1.0, 0.0});
    scene.wall.kind = WallKind::kLattice;
    const double stiffness = kWall.stiffness(largest_point_force(scene, kPoints, kSoundSpeed));
    const double limit = VelocityVerlet().step_limit(1.0 + 2.0 * stiffness * kPoints, 0.0);
    EXPECT_EQ(step(scene, {1.0, 0.0}), round_down_to_125(0.5 * limit));
    if (step(scene, {1.0, 0.0}) < one_end) ++shorter;
  }
  EXPECT_GT(shorter, 0);
}

}  // namespace
}  // namespace impact
