#include "mechanics/viscous_boundary.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/simulation.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

TEST(ViscousBoundary, DragsEachComponentByItsCoefficient) {
  const ViscousBoundary boundary({{2, {3.0, 5.0}}, {0, {0.5, 7.0}}});
  PointArray velocity(3, 2);
  velocity << 2, 0, 1, 1, -1, 0.1;
  PointArray force = PointArray::Ones(3, 2);
  const double power = boundary.add_damping_forces(velocity, force).absorbed;
  PointArray expected(3, 2);
  expected << 0, 1, 1, 1, 4, 0.5;
  EXPECT_TRUE((force == expected).all());
  EXPECT_DOUBLE_EQ(power, 2.0 + 3.0 + 0.05);
  EXPECT_EQ(boundary.largest_coefficient(), 7.0);
}

constexpr double kMass = 1.0 / 3.0;
constexpr double kCoefficient = 0.2;

/// A triangle that slides along x on equal dashpots: v = v₀ exp(−c t/m), and what is absorbed is
/// the kinetic energy lost. Both to second order in the step.
TEST(ViscousBoundary, SlowsAndAbsorbsToSecondOrder) {
  struct Error {
    double velocity;
    double ledger;
  };
  const auto error = [](double step) {
    ForceField field{BondForces(triangle(), {1.0, 0.0, 0.0}), kMass};
    field.viscous_boundary.emplace(std::vector<ViscousBoundary::Dashpot>{
        {0, {kCoefficient, 0.0}}, {1, {kCoefficient, 0.0}}, {2, {kCoefficient, 0.0}}});
    State state;
    state.position = triangle().points;
    state.velocity = PointArray::Zero(3, 2);
    state.velocity.col(0) = 0.1;
    Simulation simulation(std::move(field), state, {}, step);
    while (simulation.state().time < 2.0 - 0.5 * step) simulation.step();
    return Error{simulation.state().velocity(0, 0) - 0.1 * std::exp(-2.0 * kCoefficient / kMass),
                 simulation.ledger().total() - 0.005};
  };
  const Error coarse = error(0.02);
  const Error fine = error(0.01);
  // The next term is smaller by c h/m = 0.01.
  EXPECT_NEAR(coarse.velocity / fine.velocity, 4.0, 0.1);
  EXPECT_NEAR(coarse.ledger / fine.ledger, 4.0, 0.1);
}

}  // namespace
}  // namespace impact
