#include "mechanics/velocity_verlet.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "test_lattices.hpp"

namespace impact {
namespace {

constexpr double kStretch = 0.01;

/// Two points of mass 1/2, stretched along x and let go.
struct Oscillator {
  explicit Oscillator(const BondLaw& law) : field{BondForces(two_points(), law), 0.5} {
    state.position = two_points().points;
    state.position(1, 0) += kStretch;
    state.velocity = PointArray::Zero(2, 2);
  }

  double elongation_after(double time, double h) {
    VelocityVerlet verlet;
    verlet.restart(field, state);
    const auto steps = static_cast<int>(std::lround(time / h));
    for (int k = 0; k < steps; ++k) verlet.step(field, state, h);
    return state.position(1, 0) - state.position(0, 0) - 1.0;
  }

  ForceField field;
  State state;
};

/// Verlet on a harmonic oscillator, solved exactly: x_n = x₀ cos(n θ) with cos θ = 1 − (ωh)²/2.
TEST(VelocityVerlet, TwoPointsOnASpringFollowTheDiscreteSolution) {
  const double omega = 2.0;  // ω² = 2 k_a/m = 4
  const double h = 0.1;
  const double theta = std::acos(1.0 - omega * omega * h * h / 2.0);
  Oscillator oscillator({1.0, 0.0, 0.0});
  EXPECT_NEAR(oscillator.elongation_after(100.0, h), kStretch * std::cos(1000 * theta), 1e-13);
}

/// x(t) of ẍ = −ω² x − γ ẋ, underdamped, from rest.
double damped_oscillation(double omega, double gamma, double time) {
  const double rate = gamma / 2.0;
  const double frequency = std::sqrt(omega * omega - rate * rate);
  return kStretch * std::exp(-rate * time) *
         (std::cos(frequency * time) + rate / frequency * std::sin(frequency * time));
}

class Order : public testing::TestWithParam<double> {};

/// The error falls by four when the step is halved, damped or not.
TEST_P(Order, IsTwo) {
  const double eta = GetParam();
  const double gamma = 4.0 * eta;  // 2 η/m
  const double exact = damped_oscillation(2.0, gamma, 3.0);
  const auto error = [&](double h) {
    return std::abs(Oscillator({1.0, 0.0, eta}).elongation_after(3.0, h) - exact);
  };
  // The next term of the error makes the order differ from 2 by terms of order h.
  EXPECT_NEAR(std::log2(error(0.01) / error(0.005)), 2.0, 0.1);
  EXPECT_NEAR(std::log2(error(0.005) / error(0.0025)), 2.0, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Damping, Order, testing::Values(0.0, 0.05, 0.3));

/// What the damping takes is what the motion loses, to second order.
TEST(VelocityVerlet, DissipatedEnergyIsThatLost) {
  const auto defect = [](double h) {
    Oscillator oscillator({1.0, 0.0, 0.3});
    VelocityVerlet verlet;
    verlet.restart(oscillator.field, oscillator.state);
    double dissipated = 0.0;
    for (double t = 0.0; t < 3.0 - h / 2; t += h) {
      dissipated += verlet.step(oscillator.field, oscillator.state, h).dissipated;
    }
    const double kinetic = 0.25 * oscillator.state.velocity.square().sum();
    const double start = 0.5 * kStretch * kStretch;
    return std::abs(kinetic + oscillator.field.bonds.potential_energy(oscillator.state.position) +
                    dissipated - start);
  };
  EXPECT_NEAR(std::log2(defect(0.01) / defect(0.005)), 2.0, 0.1);
}

/// Steps forward, velocities turned round, steps back: the start again, since undamped Verlet is
/// time-reversible; only rounding is left.
TEST(VelocityVerlet, IsReversibleWithoutDamping) {
  Oscillator oscillator({1.0, 100.0, 0.0});
  const PointArray start = oscillator.state.position;
  oscillator.elongation_after(50.0, 0.05);
  oscillator.state.velocity *= -1.0;
  oscillator.elongation_after(50.0, 0.05);
  EXPECT_LT((oscillator.state.position - start).abs().maxCoeff(), 1e-12);
}

/// Spectral radius of one step for the mode ẍ = −ω² x − γ ẋ, with h = 1 and the state (x, v, a).
double spectral_radius(double omega_squared, double gamma) {
  const double w = omega_squared;
  const double g = gamma;
  Eigen::Matrix3d step;
  step.row(0) << 1.0, 1.0, 0.5;
  step.row(2) << -w, -w - g, -w / 2.0 - g;
  step.row(1) << 0.0, 1.0, 0.5;
  step.row(1) += 0.5 * step.row(2);
  return step.eigenvalues().cwiseAbs().maxCoeff();
}

/// The documented bound h² ω²/4 + h γ ≤ 1 is where stability ends, for every ratio of ω and γ.
TEST(VerletStepLimit, IsTheEdgeOfStability) {
  for (double angle = 0.0; angle <= 1.0; angle += 0.05) {
    const double omega_squared = std::cos(angle * M_PI / 2);
    const double gamma = std::sin(angle * M_PI / 2);
    const double h = VelocityVerlet().step_limit(omega_squared, gamma);
    EXPECT_NEAR(h * h * omega_squared / 4.0 + h * gamma, 1.0, 1e-12);
    const double inside = 0.999 * h;
    const double outside = 1.001 * h;
    EXPECT_LE(spectral_radius(inside * inside * omega_squared, inside * gamma), 1.0 + 1e-12);
    EXPECT_GT(spectral_radius(outside * outside * omega_squared, outside * gamma), 1.0 + 1e-6);
  }
}

}  // namespace
}  // namespace impact
