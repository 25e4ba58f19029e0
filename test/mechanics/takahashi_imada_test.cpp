#include "mechanics/takahashi_imada.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "test_lattices.hpp"

namespace impact {
namespace {

/// The distance of two points on a line, x over its natural value, after each step of length 1 of
/// the mode ẍ = −ω² x that begins at rest.
std::vector<double> distances(double omega_squared, int steps) {
  constexpr double kMass = 0.5;
  constexpr double kSize = 1e-3;  // the bond keeps its direction
  ForceField field{BondForces(two_points(), {omega_squared * kMass / 2.0, 0.0, 0.0}), kMass};
  State state{0.0, 0, two_points().points, PointArray::Zero(2, 2)};
  state.position(1, 0) += kSize;
  TakahashiImada integrator;
  integrator.restart(field, state);
  std::vector<double> x;
  for (int k = 0; k < steps; ++k) {
    integrator.step(field, state, 1.0);
    x.push_back((state.position(1, 0) - state.position(0, 0) - 1.0) / kSize);
  }
  return x;
}

/// With x = ω² h², any three places in turn obey xₙ₊₁ − (2 − x (1 − x/12)) xₙ + xₙ₋₁ = 0, to the
/// rounding of positions of order 1 over the size of the vibration.
TEST(TakahashiImada, MovesAModeAsVerletDoesASofterOne) {
  for (const double x : {0.1, 1.0, 3.0, 6.0, 9.0, 11.9}) {
    const std::vector<double> places = distances(x, 50);
    for (std::size_t n = 1; n + 1 < places.size(); ++n) {
      const double expected = (2.0 - x * (1.0 - x / 12.0)) * places[n] - places[n - 1];
      EXPECT_NEAR(places[n + 1], expected, 1e-10) << x << " " << n;
    }
  }
}

TEST(TakahashiImadaStepLimit, IsTheEdgeOfStability) {
  const double limit = TakahashiImada().step_limit(1.0, 0.0);
  EXPECT_DOUBLE_EQ(limit, std::sqrt(12.0));
  const auto largest = [&](double times) {
    double all = 0.0;
    for (const double x : distances(std::pow(times * limit, 2), 400))
      all = std::max(all, std::abs(x));
    return all;
  };
  for (const double times : {0.1, 0.5, 0.7, 0.9, 0.99, 0.999}) EXPECT_LT(largest(times), 100.0);
  EXPECT_GT(largest(1.001), 1e3);
}

}  // namespace
}  // namespace impact
