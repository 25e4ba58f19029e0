#include "mechanics/velocity_reset.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "two_bodies.hpp"

namespace impact {
namespace {

TEST(VelocityReset, TakesOutTheKineticEnergyOfItsPoints) {
  const VelocityReset reset({0, 2}, 0.1);
  PointArray velocity(3, 2);
  velocity << 1, 2, 3, 4, 5, 6;
  EXPECT_DOUBLE_EQ(reset.apply(velocity, 0.1), 0.05 * (1 + 4 + 25 + 36));
  PointArray expected(3, 2);
  expected << 0, 0, 3, 4, 0, 0;
  EXPECT_TRUE((velocity == expected).all());
  EXPECT_EQ(reset.apply(velocity, 0.1), 0.0);
}

TwoBodies bodies_with_reset(double interval, double a = 40.0) {
  TwoBodies bodies(2.4, {0.01, -0.1}, GapMeasure::kNormal, a);
  bodies.field.velocity_reset.emplace(TwoBodies::bottom(), interval);
  return bodies;
}

bool at_rest(const Simulation& simulation, const std::vector<std::int32_t>& points) {
  for (const std::int32_t point : points) {
    if ((simulation.state().velocity.row(point) != 0.0).any()) return false;
  }
  return true;
}

/// At the multiples of its interval and at no other time, also when the wall has grown too stiff
/// for the step and the step was halved.
TEST(VelocityReset, ActsAtTheMultiplesOfItsInterval) {
  constexpr double kInterval = 0.4;
  Simulation simulation = bodies_with_reset(kInterval, 4000.0).simulation(0.1);
  int resets = 0;
  int moving = 0;
  while (simulation.state().time < 10.0) {
    simulation.step();
    const double intervals = simulation.state().time / kInterval;
    const bool due = std::abs(intervals - std::round(intervals)) < 1e-9;
    if (due) {
      ++resets;
      EXPECT_TRUE(at_rest(simulation, TwoBodies::bottom())) << intervals;
    } else if (moving > 0) {
      EXPECT_FALSE(at_rest(simulation, TwoBodies::bottom())) << intervals;
    }
    if (!at_rest(simulation, TwoBodies::bottom())) ++moving;
  }
  EXPECT_GT(moving, 50);
  EXPECT_EQ(resets, 25);
  EXPECT_GT(simulation.halvings(), 0);
}

/// What is missing in the motion is in the ledger, to the integrator's order.
TEST(VelocityReset, LedgerClosesToSecondOrder) {
  const auto defect = [](double step) {
    Simulation simulation = bodies_with_reset(0.16).simulation(step);
    const double start = simulation.ledger().total();
    double largest = 0.0;
    while (simulation.state().time < 10.0) {
      simulation.step();
      largest = std::max(largest, std::abs(simulation.ledger().total() - start));
    }
    EXPECT_GT(simulation.ledger().absorbed, 10.0 * largest);
    return largest;
  };
  EXPECT_NEAR(std::log2(defect(8e-3) / defect(4e-3)), 2.0, 0.15);
}

/// Velocity of the disk's middle along y long after the collision.
double velocity_after(const TwoBodies& bodies, double step) {
  Simulation simulation = bodies.simulation(step);
  while (simulation.state().time < 16.0 - 0.5 * step) simulation.step();
  return simulation.state().velocity.col(1).head(TwoBodies::kDiskPoints).mean();
}

/// The interval being fixed, the answer converges with the step, to the integrator's order; with
/// damping this needs the forces after each reset.
TEST(VelocityReset, AnswerConvergesWithTheStep) {
  for (const double eta : {0.0, 0.05}) {
    TwoBodies bodies = bodies_with_reset(0.16);
    bodies.field.bonds = BondForces(bodies.lattice, {1.0, 0.5, eta});
    const double reference = velocity_after(bodies, 2.5e-4);
    const double coarse = velocity_after(bodies, 8e-3) - reference;
    const double fine = velocity_after(bodies, 4e-3) - reference;
    // The reference errs by (1/16)² of the fine error, terms of order h⁴ add a few per cent.
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1) << eta;
  }
}

/// With ever shorter intervals the boundary becomes a clamp: a point that is stopped after every τ
/// moves on by its acceleration times τ²/2, so the difference goes with τ.
TEST(VelocityReset, BecomesAClampAsTheIntervalGoesToZero) {
  TwoBodies clamped(2.4, {0.01, -0.1});
  clamped.field.supports.emplace(TwoBodies::bottom(), TwoBodies::bottom());
  const double fixed = velocity_after(clamped, 1e-3);
  double last = fixed - velocity_after(bodies_with_reset(0.064), 1e-3);
  EXPECT_GT(std::abs(last), 0.01 * fixed);
  for (const double interval : {0.032, 0.016, 0.008, 0.004}) {
    const double difference = fixed - velocity_after(bodies_with_reset(interval), 1e-3);
    EXPECT_NEAR(difference / last, 0.5, 0.1) << interval;
    last = difference;
  }
}

}  // namespace
}  // namespace impact
