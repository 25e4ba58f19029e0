#include "statics/large_equilibrium_solver.hpp"

#include <gtest/gtest.h>

#include "statics/equilibrium_solver.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

/// A patch pressed on a wall along its lowest row.
struct PressedPatch {
  Lattice lattice = triangular_patch(30, 20);
  ForceField field{BondForces(lattice, {1.0, 0.1, 0.0}), 1.0 / 600.0};
  State start{0.0, 0, lattice.points, PointArray::Zero(600, 2)};

  explicit PressedPatch(double load = 0.02, bool held = true) {
    // Its rim curves upwards, so that the contact grows with the load.
    start.position.col(1) += 1e-3 * (start.position.col(0) - 15.0).square();
    field.wall.emplace(30.0, 0.1);
    field.load.emplace(load, field.bonds.points());
    if (held) field.hold.emplace(lattice.points);
    start.position.col(1) += field.wall->gap_of_force(load);
  }

  EquilibriumSearch search() const { return {field, start, 1e-13}; }
};

template <class Solver>
EquilibriumSearch taken_by(Solver& solver, EquilibriumSearch search) {
  while (!search.finished()) solver.advance({&search});
  return search;
}

/// The steps differ, since each is solved to 0.1 %; the place where they end does not.
TEST(LargeEquilibriumSolver, EndsWhereNewtonsMethodEnds) {
  for (const bool held : {true, false}) {
    const PressedPatch patch(0.02, held);
    EquilibriumSolver plain;
    LargeEquilibriumSolver solver;
    const EquilibriumSearch expected = taken_by(plain, patch.search());
    const EquilibriumSearch search = taken_by(solver, patch.search());
    ASSERT_TRUE(search.found());
    ASSERT_TRUE(expected.found());
    // The soft modes of the patch are a thousand times weaker than a bond.
    constexpr double kTolerance = 1e-13 * 1e3;
    EXPECT_LT((search.state().position - expected.state().position).abs().maxCoeff(), kTolerance);
    EXPECT_LT(search.correction().abs().maxCoeff(), kTolerance);
    EXPECT_NE(search.steps(), 0U);
  }
}

/// Where the search ends before the equilibrium, the correction says how far it is to it, but for
/// what K has changed in the last step.
TEST(LargeEquilibriumSolver, SaysHowFarItIsToTheEquilibrium) {
  const PressedPatch patch;
  LargeEquilibriumSolver solver;
  const EquilibriumSearch expected = taken_by(solver, patch.search());
  const EquilibriumSearch early =
      taken_by(solver, EquilibriumSearch(patch.field, patch.start, 1e-6));
  const PointArray missing = expected.state().position - early.state().position;
  ASSERT_GT(missing.abs().maxCoeff(), 1e-8);
  EXPECT_LT((early.correction() - missing).matrix().norm(), 0.01 * missing.matrix().norm());
}

/// Neither the searches before it nor their number change a bit.
TEST(LargeEquilibriumSolver, ForgetsTheSearchBefore) {
  const PressedPatch patch(0.02);
  LargeEquilibriumSolver used;
  taken_by(used, PressedPatch(0.05).search());
  LargeEquilibriumSolver fresh;
  const EquilibriumSearch after = taken_by(used, patch.search());
  const EquilibriumSearch alone = taken_by(fresh, patch.search());
  EXPECT_EQ(after.steps(), alone.steps());
  EXPECT_TRUE((after.state().position == alone.state().position).all());
  EXPECT_TRUE((after.correction() == alone.correction()).all());
}

/// A load that no wall holds.
TEST(LargeEquilibriumSolver, SaysWhenThereIsNone) {
  ForceField field{BondForces(triangle(), {1.0, 0.0, 0.0}), 1.0 / 3.0};
  field.load.emplace(0.01, field.bonds.points());
  LargeEquilibriumSolver solver;
  EXPECT_FALSE(
      taken_by(solver, EquilibriumSearch(
                           field, State{0.0, 0, triangle().points, PointArray::Zero(3, 2)}, 1e-14))
          .found());
}

}  // namespace
}  // namespace impact
