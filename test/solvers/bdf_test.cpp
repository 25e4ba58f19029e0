#include "solvers/bdf.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mechanics/falling_patch.hpp"
#include "mechanics/oscillator.hpp"

namespace impact {
namespace {

constexpr Scales kScales{Oscillator::kStretch, 2.0 * Oscillator::kStretch};

/// About the time in which an overdamped oscillator creeps back, γ/ω², and at least 10.
double creep_time(double gamma) { return std::max(10.0, gamma); }

class BdfOscillation : public testing::TestWithParam<double> {};  // over damping rates

/// CVODE holds the error of a step to the tolerance. Where nothing damps them, the errors of all
/// steps add up, and their number rises as tolerance^(−1/6) at order 5: error ∝ tolerance^(5/6).
/// Where damping wipes them out, error ∝ tolerance. Each tolerance takes its own sequence of
/// orders: 0.1 for the scatter that this leaves in a fit over seven decades.
TEST_P(BdfOscillation, ErrorFallsWithTheTolerance) {
  const double exponent = exponent_of_tolerance(
      [](double tolerance) { return Bdf(tolerance, kScales); }, GetParam(), creep_time(GetParam()));
  EXPECT_GT(exponent, 5.0 / 6.0 - 0.1);
  EXPECT_LT(exponent, 1.0 + 0.1);
}

/// No more than the sum of the errors of all steps, of which a component may have √10 of the mean
/// square over ten. The energy's error follows from those of x and v with a factor of about four.
TEST_P(BdfOscillation, FollowsTheClosedForm) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const Oscillation found =
        oscillate(Bdf(tolerance, kScales), GetParam(), creep_time(GetParam()), 10);
    const double sum = std::sqrt(10.0) * static_cast<double>(found.evaluations) * tolerance;
    EXPECT_LT(found.error, sum);
    EXPECT_LT(found.defect, 4.0 * sum);
  }
}

INSTANTIATE_TEST_SUITE_P(Damping, BdfOscillation, testing::Values(0.2, 1.2, 30.0, 1e5));

/// Between the steps the interpolating polynomial has the order of the method.
TEST(Bdf, InterpolatesAsWellAsItSteps) {
  constexpr double kTolerance = 1e-8;
  const Oscillation found = oscillate(Bdf(kTolerance, kScales), 0.2, 10.0, 5000);
  EXPECT_LT(found.evaluations, 5000 + 500);  // one a state, besides those of its own steps
  EXPECT_LT(found.error, 500 * std::sqrt(10.0) * kTolerance);
}

/// ω²/γ = 4·10⁻⁵ against γ = 10⁵: explicit methods, with γ h ≲ 2, would take 5·10⁹ evaluations.
TEST(Bdf, CreepsOverdampedInFewSteps) {
  constexpr double kTolerance = 1e-6;
  const Oscillation found = oscillate(Bdf(kTolerance, kScales), 1e5, 1e5, 1);
  EXPECT_LT(found.evaluations, 200);
  EXPECT_LT(found.error, 200 * std::sqrt(10.0) * kTolerance);
}

/// As if the oscillator had just been let go at its present elongation.
TEST(Bdf, TakesInAVelocityReset) {
  constexpr double kTolerance = 1e-9;
  Oscillator oscillator(0.2);
  Bdf integrator(kTolerance, kScales);
  integrator.restart(oscillator.field, oscillator.state);
  integrator.step(oscillator.field, oscillator.state, 1.0);
  const double elongation = oscillator.elongation();
  oscillator.state.velocity.setZero();
  integrator.take_velocity(oscillator.field, oscillator.state);
  const double energy = oscillator.energy();
  const Losses lost = integrator.step(oscillator.field, oscillator.state, 2.0);
  EXPECT_NEAR(lost.dissipated, energy - oscillator.energy(), 300 * kTolerance * energy);
  EXPECT_NEAR(oscillator.elongation() / elongation, oscillator.exact(2.0) / Oscillator::kStretch,
              300 * kTolerance);
}

/// For falling patches.
Bdf loose() { return {1e-6, {0.1, 0.1}}; }

TEST(Bdf, KeepsTheRotationHeld) {
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

TEST(Bdf, KeepsSupportedCoordinates) {
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
TEST(Bdf, EvaluatesTheFieldLastAtTheNewState) {
  FallingPatch patch;
  patch.run(loose());
  const Eigen::Array2d left = patch.field.wall->total_force();
  PointArray force(16, 2);
  patch.field.evaluate(patch.state.position, patch.state.velocity, force);
  EXPECT_GT(left.y(), 0.0);
  EXPECT_TRUE((patch.field.wall->total_force() == left).all());
}

TEST(Bdf, SaysInOneLineThatItCannotGoOn) {
  Oscillator oscillator(0.0);
  oscillator.state.position(0, 0) = std::nan("");
  Bdf integrator(1e-6, kScales);
  integrator.restart(oscillator.field, oscillator.state);
  try {
    integrator.step(oscillator.field, oscillator.state, 1.0);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.substr(0, 5), "BDF: ");
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace impact
