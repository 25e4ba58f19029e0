#include "mechanics/imex.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "linear_mode.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

constexpr double kRightAngle = M_PI / 2.0;

/// The mid-step rule turns a mode of any frequency by an angle below π, and damps it at any rate.
/// The factor 1/(1 + x/4), x = ω² h², is known to some of its last places, which x multiplies.
TEST(Imex, IsStableForEveryModeOfTheBonds) {
  for (const double x : {1e-4, 1.0, 4.0, 1e3, 1e6}) {
    const double rounding = 1e-14 * (1.0 + x);
    EXPECT_NEAR(spectral_radius<Imex>(x, 0.0), 1.0, rounding) << x;
    for (const double gamma : {0.1, 1.0, 1e3, 1e6}) {
      EXPECT_LE(spectral_radius<Imex>(x, gamma), 1.0 + rounding) << x << " " << gamma;
    }
  }
}

/// With x = ω² h², any three places in turn of the mid-step rule obey
/// xₙ₊₁ + xₙ₋₁ = 2 xₙ (4 − x)/(4 + x).
TEST(Imex, MovesAModeAsTheMidStepRuleDoes) {
  constexpr double kMass = 0.5;
  constexpr double kSize = 1e-3;
  for (const double x : {0.1, 3.0, 50.0}) {
    ForceField field{BondForces(two_points(), {x * kMass / 2.0, 0.0, 0.0}), kMass};
    field.unstrained = std::make_shared<const PointArray>(two_points().points);
    State state{0.0, 0, two_points().points, PointArray::Zero(2, 2)};
    state.position(1, 0) += kSize;
    Imex integrator;
    integrator.restart(field, state);
    double before = 1.0;
    double now = 1.0;
    for (int n = 0; n < 20; ++n) {
      integrator.step(field, state, 1.0);
      const double next = (state.position(1, 0) - state.position(0, 0) - 1.0) / kSize;
      // Rounding of positions over the size of the vibration, and what the steps make of it.
      if (n > 0) {
        EXPECT_NEAR(next + before, 2.0 * now * (4.0 - x) / (4.0 + x), 1e-10) << x;
      }
      before = now;
      now = next;
    }
  }
}

PointArray turned(const PointArray& vectors, double angle) {
  PointArray result(vectors.rows(), 2);
  result.col(0) = std::cos(angle) * vectors.col(0) - std::sin(angle) * vectors.col(1);
  result.col(1) = std::sin(angle) * vectors.col(0) + std::cos(angle) * vectors.col(1);
  return result;
}

/// Of a damped patch that is stretched, vibrates and spins.
struct Moving {
  explicit Moving(double angle)
      : field{BondForces(triangular_patch(4), {1.0, 0.5, 0.02}), 1.0 / 16.0},
        state{0.0, 0, {}, {}} {
    const PointArray points = triangular_patch(4).points;
    field.unstrained = std::make_shared<const PointArray>(points);
    PointArray position = points;
    position.col(0) *= 1.01;
    PointArray velocity(16, 2);
    velocity.col(0) = -0.02 * points.col(1) + 0.01 * points.col(0).sin();
    velocity.col(1) = 0.02 * points.col(0);
    state.position = turned(position, angle);
    state.velocity = turned(velocity, angle);
  }

  void advance(int steps, double h) {
    Imex integrator;
    integrator.restart(field, state);
    for (int k = 0; k < steps; ++k) integrator.step(field, state, h);
  }

  ForceField field;
  State state;
};

/// The stiffness turns with the lattice: what happens does not depend on how that lies.
TEST(Imex, MovesATurnedLatticeAsItMovesOneThatLies) {
  Moving lying(0.0);
  lying.advance(20, 0.5);
  for (const double angle : {0.3, kRightAngle, 3.0, -2.0}) {
    Moving other(angle);
    other.advance(20, 0.5);
    // 20 steps of sums of order 1.
    EXPECT_LT((other.state.position - turned(lying.state.position, angle)).abs().maxCoeff(), 1e-12)
        << angle;
  }
}

/// Without damping a step and one back lead to where it began, up to the angle of the stiffness.
TEST(Imex, IsSymmetricUpToTheFifthOrder) {
  const auto missed = [](double h) {
    Moving patch(0.4);
    patch.field.bonds = patch.field.bonds.with({1.0, 0.5, 0.0});
    patch.advance(20, 0.05);
    const PointArray begin = patch.state.position;
    patch.advance(1, h);
    patch.state.velocity *= -1.0;
    patch.advance(1, h);
    return (patch.state.position - begin).abs().maxCoeff();
  };
  EXPECT_GT(missed(0.05), 1e-13);  // that there is something to see
  EXPECT_GT(missed(0.1) / missed(0.05), std::pow(2.0, 4.8));
}

TEST(Imex, CountsWhatTheDampingTakes) {
  Moving patch(0.2);
  const auto energy = [&] {
    return 0.5 / 16.0 * patch.state.velocity.square().sum() +
           patch.field.bonds.potential_energy(patch.state.position);
  };
  const double before = energy();
  Imex integrator;
  integrator.restart(patch.field, patch.state);
  double dissipated = 0.0;
  for (int k = 0; k < 400; ++k) {
    dissipated += integrator.step(patch.field, patch.state, 0.02).dissipated;
  }
  EXPECT_GT(dissipated, 0.1 * before);
  EXPECT_NEAR(dissipated + energy(), before, 1e-4 * before);  // (ω h)²/12 with ω h = 0.2 at most
}

/// However long the step: rounding of (ω h)² makes no relative velocities of the common one, which
/// damping would take for a loss.
TEST(Imex, LosesNothingInAFlightOfAllPointsTogether) {
  Moving patch(0.0);
  patch.state.position = *patch.field.unstrained;
  patch.state.velocity.col(0).setConstant(0.3);
  patch.state.velocity.col(1).setConstant(-0.7);
  Imex integrator;
  integrator.restart(patch.field, patch.state);
  constexpr double kStep = 1e4;
  const double dissipated = integrator.step(patch.field, patch.state, kStep).dissipated;
  // Over the step by relative velocities of some units of rounding, with the damping of 42 bonds.
  EXPECT_LT(dissipated, kStep * 42.0 * 0.02 * std::pow(1e-15, 2));
}

TEST(Imex, WantsUnstrainedPositions) {
  Moving patch(0.0);
  patch.field.unstrained.reset();
  EXPECT_THROW(Imex().restart(patch.field, patch.state), std::invalid_argument);
}

}  // namespace
}  // namespace impact
