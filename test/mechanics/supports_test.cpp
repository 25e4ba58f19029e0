#include "mechanics/supports.hpp"

#include <gtest/gtest.h>

#include "mechanics/simulation.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

TEST(Supports, TakeAwayTheForceOnWhatIsHeld) {
  const Supports supports({0, 2}, {2});
  PointArray force(3, 2);
  force << 1, 2, 3, 4, 5, 6;
  supports.constrain(force);
  PointArray expected(3, 2);
  expected << 0, 2, 3, 4, 0, 0;
  EXPECT_TRUE((force == expected).all());
}

/// A held coordinate that starts at rest stays where it is, bit for bit, whatever shakes the
/// others, and does no work: the energy closes to the integrator's order (h ω)²/8 of the 10⁻² that
/// is in motion.
TEST(Supports, HoldAPointInAMotion) {
  const Lattice lattice = triangular_patch(4);
  ForceField field{BondForces(lattice, {1.0, 0.0, 0.0}), 1.0 / 16.0};
  field.supports.emplace(std::vector<std::int32_t>{0, 3}, std::vector<std::int32_t>{3});
  State state;
  state.position = lattice.points;
  state.position.row(9) += 0.1;
  state.velocity = PointArray::Zero(16, 2);
  Simulation simulation(std::move(field), state, {}, 0.002);
  const double energy = simulation.ledger().total();
  for (int k = 0; k < 2000; ++k) simulation.step();
  const PointArray& position = simulation.state().position;
  EXPECT_EQ(position(0, 0), lattice.points(0, 0));
  EXPECT_TRUE((position.row(3) == lattice.points.row(3)).all());
  EXPECT_GT(std::abs(position(0, 1) - lattice.points(0, 1)), 1e-3);
  EXPECT_NEAR(simulation.ledger().total() / energy, 1.0, 1e-4);
}

}  // namespace
}  // namespace impact
