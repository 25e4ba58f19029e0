#include "mechanics/force_field.hpp"

#include <gtest/gtest.h>

#include "test_lattices.hpp"

namespace impact {
namespace {

using Names = std::vector<std::string>;

TEST(ForceField, HasOnlyTheTermsItWasGiven) {
  ForceField field{BondForces(triangle(), {1.0, 0.0, 0.0}), 1.0 / 3.0};
  EXPECT_EQ(field.terms(), Names{"bonds"});
  field.wall.emplace(300.0, 0.1);
  EXPECT_EQ(field.terms(), (Names{"bonds", "potential wall"}));
  field.load.emplace(0.01, field.bonds.points());
  field.hold.emplace(triangle().points);
  EXPECT_EQ(field.terms(), (Names{"bonds", "potential wall", "compression load", "rotation hold"}));
}

TEST(ForceField, NamesTheTermsOfAnElasticWall) {
  const PointArray points = triangle().points;
  ForceField field{BondForces(triangle(), {1.0, 0.0, 0.0}), 1.0};
  EXPECT_EQ(field.contact(), nullptr);
  EXPECT_FALSE(field.damped());
  field.others = {Body{1, 2, false}};
  field.elastic_wall.emplace(Repulsion(300.0, 0.1), 0.2, GapMeasure::kNormal,
                             std::vector<std::int32_t>{0}, std::vector<std::int32_t>{1, 2}, points);
  EXPECT_EQ(field.contact(), &*field.elastic_wall);
  field.velocity_reset.emplace(std::vector<std::int32_t>{2}, 0.1);
  field.supports.emplace(std::vector<std::int32_t>{2}, std::vector<std::int32_t>{});
  EXPECT_FALSE(field.damped());
  field.viscous_boundary.emplace(std::vector<ViscousBoundary::Dashpot>{{2, {1.0, 1.0}}});
  EXPECT_TRUE(field.damped());
  EXPECT_EQ(field.terms(),
            (Names{"bonds", "elastic wall", "viscous boundary", "velocity reset", "supports"}));
}

TEST(ForceField, SumsItsTerms) {
  ForceField field{BondForces(triangle(), {1.0, 0.0, 0.0}), 1.0 / 3.0};
  field.wall.emplace(10.0, 0.1);
  field.load.emplace(0.3, field.bonds.points());
  PointArray force(3, 2);
  field.evaluate(triangle().points, PointArray::Zero(3, 2), force);
  // At rest in the reference configuration the bonds are silent.
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(force(i, 1), field.wall->force_at(triangle().points(i, 1)) - 0.1);
  }
}

/// What is left of all forces without the elastic ones, constraints included.
TEST(ForceField, DampingIsWhatDependsOnVelocities) {
  ForceField field{BondForces(triangle(), {1.0, 0.5, 0.3}), 1.0 / 3.0};
  field.wall.emplace(10.0, 0.1);
  field.viscous_boundary.emplace(std::vector<ViscousBoundary::Dashpot>{{2, {0.2, 0.7}}});
  field.supports.emplace(std::vector<std::int32_t>{0}, std::vector<std::int32_t>{});
  const PointArray position = 1.1 * triangle().points;
  PointArray velocity(3, 2);
  velocity << 0.1, -0.3, 0.2, 0.4, -0.5, 0.6;
  PointArray all(3, 2);
  PointArray undamped(3, 2);
  PointArray damping = PointArray::Constant(3, 2, 7.0);
  const Losses expected = field.evaluate(position, velocity, all);
  field.evaluate_undamped(position, undamped);
  const Losses found = field.evaluate_damping(velocity, damping);
  EXPECT_EQ(found.dissipated, expected.dissipated);
  EXPECT_EQ(found.absorbed, expected.absorbed);
  EXPECT_GT(found.absorbed, 0.0);
  EXPECT_LT((damping - (all - undamped)).abs().maxCoeff(), 1e-15);  // of sums of order 1
}

TEST(ForceField, PotentialEnergyIsThatOfItsTerms) {
  ForceField field{BondForces(triangle(), {1.0, 0.0, 0.0}), 1.0 / 3.0};
  const PointArray position = 1.1 * triangle().points;
  EXPECT_EQ(field.potential_energy(position), field.bonds.potential_energy(position));
  field.wall.emplace(10.0, 0.1);
  field.load.emplace(0.3, field.bonds.points());
  EXPECT_DOUBLE_EQ(field.potential_energy(position), field.bonds.potential_energy(position) +
                                                         field.wall->potential_energy(position) +
                                                         field.load->potential_energy(position));
}

/// −∂F/∂r by differences, with the wall's part, and the supported coordinate coupled to nothing.
TEST(ForceField, StiffnessIsTheDerivativeOfTheForce) {
  ForceField field{BondForces(triangle(), {1.0, 3.0, 0.0}), 1.0 / 3.0};
  field.wall.emplace(10.0, 0.1);
  field.supports.emplace(std::vector<std::int32_t>{1}, std::vector<std::int32_t>{});
  const PointArray position = 1.1 * triangle().points;
  const auto entries = field.stiffness(position);
  Eigen::SparseMatrix<double> sparse(6, 6);
  sparse.setFromTriplets(entries.begin(), entries.end());
  const Eigen::MatrixXd stiffness = sparse;

  constexpr double kMove = 1e-6;
  constexpr int kHeld = 1;
  PointArray above(3, 2);
  PointArray below(3, 2);
  for (int column = 0; column < 6; ++column) {
    if (column == kHeld) continue;
    PointArray moved = position;
    moved(column % 3, column / 3) += kMove;
    field.evaluate_undamped(moved, above);
    moved(column % 3, column / 3) -= 2 * kMove;
    field.evaluate_undamped(moved, below);
    const PointArray derivative = (below - above) / (2 * kMove);
    for (int row = 0; row < 6; ++row) {
      // kMove²/6 of the third derivative, a² times the wall's stiffness of 10: 2·10⁻¹⁰.
      EXPECT_NEAR(stiffness(row, column), derivative(row % 3, row / 3), 1e-9);
    }
    EXPECT_EQ(stiffness(kHeld, column), 0.0);
    EXPECT_EQ(stiffness(column, kHeld), 0.0);
  }
  EXPECT_GT(stiffness(kHeld, kHeld), 0.0);
}

}  // namespace
}  // namespace impact
