#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "statics/equilibrium_solver.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

EquilibriumSearch solved(const ForceField& field, const PointArray& position, double tolerance) {
  EquilibriumSearch search(field, State{0.0, 0, position, PointArray::Zero(position.rows(), 2)},
                           tolerance);
  solve(search);
  return search;
}

/// A triangle on one corner: the corner carries the load, and both legs carry half of it each.
TEST(FindEquilibrium, OfATriangleOnItsCorner) {
  PointArray points(3, 2);
  points << 0, 0, -0.5, std::sqrt(0.75), 0.5, std::sqrt(0.75);
  const Lattice lattice = plain_lattice(points, {{0, 1}, {0, 2}, {1, 2}});
  ForceField field{BondForces(lattice, {1.0, 0.0, 0.0}), 1.0 / 3.0};
  field.wall.emplace(300.0, 0.1);
  field.load.emplace(0.003, field.bonds.points());
  field.hold.emplace(points);
  PointArray position = points;
  position.col(1) += field.wall->gap_of_force(0.003);
  const EquilibriumSearch search = solved(field, position, 1e-15);
  ASSERT_TRUE(search.found());
  position = search.state().position;

  EXPECT_NEAR(field.wall->force_at(position(0, 1)), 0.003, 1e-14);
  // Each upper corner's share 0.001 of the load goes down a leg under 60°: compression
  // 0.001/sin 60°; the base is stretched by its horizontal part. Small rotations of the bonds
  // change this by relative terms of the strain, 10⁻³.
  const double leg = 0.001 / std::sin(M_PI / 3.0);
  const auto length = [&](int i, int j) {
    return (position.row(i) - position.row(j)).matrix().norm();
  };
  EXPECT_NEAR(length(0, 1) - 1.0, -leg, 5e-3 * leg);
  EXPECT_NEAR(length(0, 2) - 1.0, -leg, 5e-3 * leg);
  EXPECT_NEAR(length(1, 2) - 1.0, 0.5 * leg, 5e-3 * leg);
}

/// A free triangle of unit masses has ω² = 0 three times (rigid motions), 3 k_a/(2m) twice and
/// 3 k_a/m (breathing).
TEST(Stiffness, GivesTheFrequenciesOfATriangle) {
  Eigen::SparseMatrix<double> sparse(6, 6);
  const auto entries = BondForces(triangle(), {1.0, 5.0, 0.0}).stiffness(triangle().points);
  sparse.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd omega_squared =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(sparse)).eigenvalues();
  const double expected[] = {0.0, 0.0, 0.0, 1.5, 1.5, 3.0};
  for (Eigen::Index k = 0; k < 6; ++k) EXPECT_NEAR(omega_squared(k), expected[k], 1e-14);
}

/// The entries of the stiffness are the derivatives of the forces.
TEST(Stiffness, IsMinusTheDerivativeOfTheForce) {
  const Lattice lattice = triangular_patch(3);
  BondForces bonds(lattice, {1.0, 5.0, 0.0});
  std::srand(1);
  const PointArray position = lattice.points + 0.1 * PointArray::Random(9, 2);
  Eigen::SparseMatrix<double> sparse(18, 18);
  const auto entries = bonds.stiffness(position);
  sparse.setFromTriplets(entries.begin(), entries.end());
  const Eigen::MatrixXd stiffness = sparse;
  constexpr double kStep = 1e-6;
  for (Eigen::Index column = 0; column < 18; ++column) {
    const auto force_at = [&](double shift) {
      PointArray moved = position;
      moved.data()[column] += shift;
      PointArray force = PointArray::Zero(9, 2);
      bonds.evaluate(moved, PointArray::Zero(9, 2), force);
      return force;
    };
    const PointArray slope = (force_at(-kStep) - force_at(kStep)) / (2.0 * kStep);
    for (Eigen::Index row = 0; row < 18; ++row) {
      // Central differences: truncation of order step² and rounding of order 10⁻¹⁵/step.
      EXPECT_NEAR(stiffness(row, column), slope.data()[row], 1e-8);
    }
  }
}

TEST(FindEquilibrium, KeepsTheHeldRotationAndTheCentre) {
  const Lattice lattice = triangular_patch(4);
  ForceField field{BondForces(lattice, {1.0, 0.0, 0.0}), 1.0 / 16.0};
  field.wall.emplace(100.0, 0.1);
  field.load.emplace(0.01, field.bonds.points());
  field.hold.emplace(lattice.points);
  PointArray position = lattice.points;
  position.col(1) += field.wall->gap_of_force(0.01);
  const EquilibriumSearch search = solved(field, position, 1e-14);
  ASSERT_TRUE(search.found());
  position = search.state().position;
  EXPECT_NEAR((field.hold->direction() * (position - lattice.points)).sum(), 0.0, 1e-12);
  EXPECT_NEAR(position.col(0).mean(), lattice.points.col(0).mean(), 1e-14);
}

/// A triangle falls off its corner: where it stands, its energy is not convex, and the stiffness is
/// shifted for the next attempt, before which the search may be stopped.
TEST(FindEquilibrium, GoesOnWhereItWasStopped) {
  PointArray points(3, 2);
  points << 0, 0, -0.5, std::sqrt(0.75), 0.5, std::sqrt(0.75);
  ForceField field{BondForces(plain_lattice(points, {{0, 1}, {0, 2}, {1, 2}}), {1.0, 0.0, 0.0}),
                   1.0 / 3.0};
  field.wall.emplace(30.0, 0.1);
  field.load.emplace(0.003, field.bonds.points());
  PointArray position = points;
  position.col(0) += 0.01 * points.col(1);
  position.col(1) += field.wall->gap_of_force(0.003) - 0.01 * points.col(0);
  const EquilibriumSearch at_once = solved(field, position, 1e-14);
  ASSERT_TRUE(at_once.found());

  EquilibriumSearch search(field, State{0.0, 0, position, PointArray::Zero(3, 2)}, 1e-14);
  int asked = 0;
  double largest = 0.0;
  int kept = 0;  // steps that begin with a shift
  while (!solve(search, [&] { return ++asked % 2 == 0; })) {
    if (search.shift() > 0.0 && search.needs_stiffness()) {
      EXPECT_NEAR(search.shift(), largest / 100.0, 1e-9 * largest);
      ++kept;
    }
    largest = search.shift() > 0.0 && !search.needs_stiffness() ? search.shift() : 0.0;
  }
  EXPECT_GT(kept, 0);
  EXPECT_EQ(search.steps(), at_once.steps());
  EXPECT_TRUE((search.state().position == at_once.state().position).all());
  EXPECT_TRUE((search.correction() == at_once.correction()).all());
}

/// From a height of 300 ranges of the wall a patch falls in steps that grow, and comes to rest
/// where it does from close by.
TEST(FindEquilibrium, FallsInGrowingSteps) {
  const Lattice lattice = triangular_patch(4);
  ForceField field{BondForces(lattice, {1.0, 0.0, 0.0}), 1.0 / 16.0};
  field.wall.emplace(300.0, 0.1);
  field.load.emplace(0.01, field.bonds.points());
  field.hold.emplace(lattice.points);
  PointArray position = lattice.points;
  position.col(1) += field.wall->gap_of_force(0.01);
  const EquilibriumSearch close = solved(field, position, 1e-14);
  position.col(1) += 1.0;
  const EquilibriumSearch search = solved(field, position, 1e-14);
  ASSERT_TRUE(close.found());
  ASSERT_TRUE(search.found());
  // 100 steps of three ranges, but 10 if each is half as long again as the one before.
  EXPECT_LE(search.steps(), close.steps() + 12);
  EXPECT_LT((search.state().position - close.state().position).abs().maxCoeff(), 1e-12);
}

/// A load that no wall holds: no equilibrium, and it is said.
TEST(FindEquilibrium, SaysWhenThereIsNone) {
  ForceField field{BondForces(triangle(), {1.0, 0.0, 0.0}), 1.0 / 3.0};
  field.load.emplace(0.01, field.bonds.points());
  EXPECT_FALSE(solved(field, triangle().points, 1e-14).found());
}

/// A triangular patch drawn out by grips that let its ends contract. Uniaxial stress leaves the
/// inclined bonds without tension, so that the solution is exact: every row is stretched evenly,
/// every inclined bond keeps its length. E = 2/√3 k_a, ν = 1/3.
TEST(FindEquilibrium, OfAStretchedPatchWithFrictionlessGrips) {
  constexpr int kColumns = 9;
  constexpr int kRows = 6;
  constexpr double kStrain = 1e-3;
  const Lattice lattice = triangular_patch(kColumns, kRows);
  ForceField field{BondForces(lattice, {1.0, 0.0, 0.0}), 1.0};
  std::vector<std::int32_t> grips;
  for (int row = 0; row < kRows; ++row) {
    grips.push_back(row * kColumns);
    grips.push_back(row * kColumns + kColumns - 1);
  }
  field.supports.emplace(grips, std::vector<std::int32_t>{});
  PointArray position = lattice.points;
  for (const std::int32_t point : grips) position(point, 0) *= 1.0 + kStrain;
  const EquilibriumSearch search = solved(field, position, 1e-14);
  ASSERT_TRUE(search.found());
  position = search.state().position;

  // A force of 10⁻¹⁴ stops the search; soft modes are weaker than a bond by about 100.
  constexpr double kRest = 1e-12;
  const PointArray stretched = (1.0 + kStrain) * lattice.points;
  EXPECT_LT((position.col(0) - stretched.col(0)).abs().maxCoeff(), kRest);
  for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
    const auto [i, j] = lattice.bonds[k];
    const bool in_row = i / kColumns == j / kColumns;
    EXPECT_NEAR((position.row(i) - position.row(j)).matrix().norm(), in_row ? 1.0 + kStrain : 1.0,
                kRest);
  }
  PointArray force = PointArray::Zero(position.rows(), 2);
  field.bonds.evaluate(position, position, force);
  double pull = 0.0;
  for (int row = 0; row < kRows; ++row) pull += force(row * kColumns, 0);
  const double height = kRows * std::sqrt(0.75);  // one row's share of it each
  EXPECT_NEAR(pull / height / kStrain, 2.0 / std::sqrt(3.0), 1e-8);
  const double contraction =
      1.0 - (position(position.rows() - 1, 1) - position(0, 1)) / ((kRows - 1) * std::sqrt(0.75));
  // To the order of the strain.
  EXPECT_NEAR(contraction / kStrain, 1.0 / 3.0, kStrain);
}

}  // namespace
}  // namespace impact
