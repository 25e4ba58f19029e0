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
          verlet_step_limit(spectrum.omega_squared + wall * kPoints, spectrum.gamma);
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

}  // namespace
}  // namespace impact
