#include "reference/precise_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "statics/equilibrium_solver.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

Lattice triangle_on_its_tip() {
  PointArray points(3, 2);
  points << 0, 0, -0.5, std::sqrt(0.75), 0.5, std::sqrt(0.75);
  return plain_lattice(points, {{0, 1}, {0, 2}, {1, 2}});
}

class Load : public testing::TestWithParam<double> {};  // M c²/R

/// A third of the load on each of the upper points: the sides bear P/(3 sin 60°), the height loses
/// P/(2 k_a) and the centre of mass P/(3 k_a), but for terms of the relative size P/k_a.
TEST_P(Load, CompressesATriangleAsInTheClosedForm) {
  const Lattice lattice = triangle_on_its_tip();
  for (const double k_a : {0.1, 10.0}) {
    const PressedDisk disk{lattice, {k_a, 0.0, 0.0}, 300.0, GetParam()};
    const PreciseStrain strain = precise_strain(disk, lattice.points);
    EXPECT_NEAR(strain.value / (GetParam() / (3.0 * k_a)), 1.0, 5.0 * GetParam() / k_a);
    EXPECT_LT(strain.error, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Load, testing::Values(1e-12, 1e-10, 1e-6, 1e-4));

/// Of a patch with its lowest row on the wall, against the equilibrium in positions; its rounding
/// is 10⁻¹⁶ over a strain of 10⁻³, some ten times.
TEST(PreciseStrain, AgreesWithTheEquilibriumSearch) {
  const Lattice lattice = triangular_patch(5, 4);
  const BondLaw law{1.0, 100.0, 0.0};
  const double load = 3e-3;
  const PotentialWall wall(50.0, 1.0);
  ForceField field{BondForces(lattice, law), 0.05};
  field.wall = wall;
  field.load.emplace(load, field.bonds.points());
  field.hold.emplace(lattice.points);
  State start{0.0, 0, lattice.points, PointArray::Zero(20, 2)};
  start.position.col(1) += wall.gap_of_force(load);
  EquilibriumSearch search(field, start, 1e-15);
  solve(search);

  const PointArray& rest = search.state().position;
  const double found = rest.col(1).minCoeff() - rest.col(1).mean() -
                       lattice.points.col(1).minCoeff() + lattice.points.col(1).mean();
  const PreciseStrain strain = precise_strain({lattice, law, wall.a(), load}, lattice.points);
  EXPECT_NEAR(strain.value / found, 1.0, 1e-11);
}

}  // namespace
}  // namespace impact
