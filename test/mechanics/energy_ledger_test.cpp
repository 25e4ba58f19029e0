#include "mechanics/energy_ledger.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/force_field.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

/// A triangle of mass 1 that flies at (3, 4), spins at 2 and breathes with speed 1.
TEST(EnergyLedger, SplitsTheKineticEnergy) {
  const PointArray arm = triangle().points.rowwise() - triangle().points.colwise().mean();
  const ForceField field{BondForces(triangle(), {1.0, 0.0, 0.0}), 1.0 / 3.0};
  State state;
  state.position = triangle().points;
  state.velocity.resize(3, 2);
  const double outward = std::sqrt(3.0);  // of the unit arm 1/√3
  state.velocity.col(0) = 3.0 - 2.0 * arm.col(1) + outward * arm.col(0);
  state.velocity.col(1) = 4.0 + 2.0 * arm.col(0) + outward * arm.col(1);
  const EnergyLedger ledger = field.ledger(state, {0.125, 0.0});
  EXPECT_NEAR(ledger.kinetic_translation, 12.5, 1e-13);
  EXPECT_NEAR(ledger.kinetic_rotation, 0.5 * 4.0 / 3.0, 1e-13);
  EXPECT_NEAR(ledger.kinetic_internal, 0.5, 1e-13);
  EXPECT_EQ(ledger.dissipated, 0.125);
  EXPECT_NEAR(ledger.total(), 13.0 + 2.0 / 3.0 + 0.125, 1e-13);
}

TEST(EnergyLedger, CountsOnlyTheTermsThereAre) {
  ForceField field{BondForces(triangle(), {1.0, 0.0, 0.0}), 1.0 / 3.0};
  State state;
  state.position = triangle().points;
  state.position.col(0) *= 1.01;
  state.velocity = PointArray::Zero(3, 2);
  const EnergyLedger bare = field.ledger(state, {});
  EXPECT_GT(bare.bonds, 0.0);
  EXPECT_EQ(bare.wall, 0.0);
  EXPECT_EQ(bare.load, 0.0);
  field.wall.emplace(10.0, 0.1);
  field.load.emplace(0.3, field.bonds.points());
  const EnergyLedger full = field.ledger(state, {});
  EXPECT_EQ(full.wall, field.wall->potential_energy(state.position));
  EXPECT_EQ(full.load, field.load->potential_energy(state.position));
}

/// Of an elastic wall: its own motion and bonds apart from the disk's.
TEST(EnergyLedger, KeepsTheWallApartFromTheDisk) {
  PointArray above = triangle().points;
  above.col(1) += 2.0;
  const Lattice both = joined(plain_lattice(above, triangle().bonds), triangle());
  ForceField field{BondForces(both, {1.0, 0.0, 0.0}), 1.0 / 3.0};
  field.others = {Body{3, 3, false}};
  field.elastic_wall.emplace(Repulsion(10.0, 0.1), 0.2, GapMeasure::kNormal,
                             std::vector<std::int32_t>{0, 1, 2}, std::vector<std::int32_t>{3, 4},
                             both.points);
  State state;
  state.position = both.points;
  state.position(0, 0) -= 0.2;  // stretches one bond of the disk by 0.2, changes another
  state.position(4, 0) += 0.1;
  state.velocity = PointArray::Zero(6, 2);
  state.velocity.topRows(3).col(0) = 2.0;
  state.velocity(5, 1) = 3.0;
  const EnergyLedger ledger = field.ledger(state, {0.0, 0.25});
  EXPECT_DOUBLE_EQ(ledger.kinetic(), 2.0);
  const double bonds = field.bonds.potential_energy(state.position);
  const double of_wall = field.bonds.potential_energy(state.position, 3, 6);
  EXPECT_GT(of_wall, 0.004);
  EXPECT_DOUBLE_EQ(ledger.wall_lattice, 1.5 + of_wall);
  EXPECT_DOUBLE_EQ(ledger.bonds + of_wall, bonds);
  EXPECT_EQ(ledger.absorbed, 0.25);
  EXPECT_DOUBLE_EQ(ledger.total(), 2.0 + 1.5 + bonds + 0.25);
}

/// A triangle of 1 M that flies at 1, and a rod of two points, 2/3 M and 2/3 M R², that flies
/// at 1.5 and spins at 2.
TEST(EnergyLedger, WeighsOtherFreeBodies) {
  PointArray rod(2, 2);
  rod << -1.0, -5.0, 1.0, -5.0;
  const Lattice both = joined(triangle(), plain_lattice(rod, {{0, 1}}));
  ForceField field{BondForces(both, {1.0, 0.0, 0.0}), 1.0 / 3.0};
  field.others = {Body{3, 2, true}};
  State state;
  state.position = both.points;
  state.velocity.resize(5, 2);
  state.velocity << 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, -1.5 - 2.0, 0.0, -1.5 + 2.0;
  const EnergyLedger ledger = field.ledger(state, {});
  EXPECT_NEAR(ledger.kinetic_translation, 0.5 + 0.5 * 2.0 / 3.0 * 1.5 * 1.5, 1e-14);
  EXPECT_NEAR(ledger.kinetic_rotation, 0.5 * 2.0 / 3.0 * 2.0 * 2.0, 1e-14);
  EXPECT_NEAR(ledger.kinetic_internal, 0.0, 1e-14);
  EXPECT_EQ(ledger.wall_lattice, 0.0);
}

}  // namespace
}  // namespace impact
