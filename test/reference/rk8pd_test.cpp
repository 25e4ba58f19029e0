#include "reference/rk8pd.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "mechanics/falling_patch.hpp"
#include "mechanics/oscillator.hpp"

namespace impact {
namespace {

constexpr Scales kOscillatorScales{Oscillator::kStretch, 2.0 * Oscillator::kStretch};

class Rk8pdOscillation : public testing::TestWithParam<double> {};  // over damping rates

/// The error of a step is held to the tolerance, and the number of steps rises as tolerance^(−1/8)
/// at most: error ∝ tolerance^(7/8) where errors add up, ∝ tolerance where damping wipes them out.
/// 0.1 for the scatter: the few long steps at loose tolerances do better than they have to.
TEST_P(Rk8pdOscillation, ErrorFallsWithTheTolerance) {
  const double exponent = exponent_of_tolerance(
      [](double tolerance) { return Rk8pd(tolerance, kOscillatorScales); }, GetParam(), 10.0);
  EXPECT_GT(exponent, 7.0 / 8.0 - 0.1);
  EXPECT_LT(exponent, 1.0 + 0.1);
}

/// No more than the sum of the errors of all steps, at 13 evaluations each.
TEST_P(Rk8pdOscillation, FollowsTheClosedForm) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    const Oscillation found = oscillate(Rk8pd(tolerance, kOscillatorScales), GetParam(), 10.0, 10);
    const double sum = static_cast<double>(found.evaluations) / 13.0 * tolerance;
    EXPECT_LT(found.error, sum);
    EXPECT_LT(found.defect, sum);
  }
}

INSTANTIATE_TEST_SUITE_P(Damping, Rk8pdOscillation, testing::Values(0.0, 0.2, 1.2));

/// As if the oscillator had just been let go at its present elongation.
TEST(Rk8pd, TakesInAVelocityReset) {
  constexpr double kTolerance = 1e-9;
  Oscillator oscillator(0.2);
  Rk8pd integrator(kTolerance, kOscillatorScales);
  integrator.restart(oscillator.field, oscillator.state);
  integrator.step(oscillator.field, oscillator.state, 1.0);
  const double elongation = oscillator.elongation();
  oscillator.state.velocity.setZero();
  integrator.take_velocity(oscillator.field, oscillator.state);
  integrator.step(oscillator.field, oscillator.state, 2.0);
  EXPECT_NEAR(oscillator.elongation() / elongation, oscillator.exact(2.0) / Oscillator::kStretch,
              10 * kTolerance);
}

/// For falling patches.
Rk8pd loose() { return {1e-6, {0.1, 0.1}}; }

TEST(Rk8pd, KeepsTheRotationHeld) {
  FallingPatch patch;
  patch.field.hold.emplace(patch.lattice.points);
  const PointArray start = patch.state.position;
  patch.run(loose(), 500);             // errors along the constraint, if they grew, would by now
  constexpr double kRounding = 1e-12;  // 10⁻¹⁶ of 32 products of up to 3, in some hundred steps
  const PointArray& direction = patch.field.hold->direction();
  const PointArray moves = patch.state.position - start;
  EXPECT_GT(moves.abs().maxCoeff(), 0.02);
  EXPECT_NEAR((direction * moves).sum(), 0.0, kRounding);
  EXPECT_NEAR((direction * patch.state.velocity).sum(), 0.0, kRounding);
}

TEST(Rk8pd, KeepsSupportedCoordinates) {
  FallingPatch patch;
  patch.state.velocity(0, 0) = patch.state.velocity(5, 1) = 0.0;
  patch.field.supports.emplace(std::vector<std::int32_t>{0}, std::vector<std::int32_t>{5});
  const PointArray start = patch.state.position;
  patch.run(loose());
  EXPECT_GT((patch.state.position - start).abs().maxCoeff(), 0.02);
  EXPECT_EQ(patch.state.position(0, 0), start(0, 0));
  EXPECT_EQ(patch.state.position(5, 1), start(5, 1));
}

/// The contact forces that a step leaves behind are those of the state that it leaves behind.
TEST(Rk8pd, EvaluatesTheFieldLastAtTheNewState) {
  FallingPatch patch;
  patch.run(loose());
  const Eigen::Array2d left = patch.field.wall->total_force();
  PointArray force(16, 2);
  patch.field.evaluate(patch.state.position, patch.state.velocity, force);
  EXPECT_GT(left.y(), 0.0);
  EXPECT_TRUE((patch.field.wall->total_force() == left).all());
}

TEST(Rk8pd, SaysInOneLineThatItCannotGoOn) {
  Oscillator oscillator(0.0);
  oscillator.state.position(0, 0) = std::nan("");
  Rk8pd integrator(1e-6, kOscillatorScales);
  integrator.restart(oscillator.field, oscillator.state);
  try {
    integrator.step(oscillator.field, oscillator.state, 1.0);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.substr(0, 7), "rk8pd: ");
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(Rk8pd, GivesUpAfterTheStatedNumberOfSteps) {
  Oscillator oscillator(0.0);
  Rk8pd integrator(1e-10, kOscillatorScales, 3);
  integrator.restart(oscillator.field, oscillator.state);
  EXPECT_THROW(integrator.step(oscillator.field, oscillator.state, 100.0), std::runtime_error);
}

}  // namespace
}  // namespace impact
