#include "solvers/reduced_system.hpp"

#include <gtest/gtest.h>

#include "test_lattices.hpp"

namespace impact {
namespace {

constexpr double kGamma = 0.3;

/// A patch on the wall, its bottom row strained, damped.
struct Patch {
  Patch() {
    field.wall.emplace(10.0, 0.1);
    position = 1.02 * lattice.points;
    position.col(1) += 0.05 * position.col(0);
  }

  Eigen::VectorXd solved(const Eigen::VectorXd& r) const {
    ReducedSystem system(field);
    system.set_stiffness(field, position);
    EXPECT_TRUE(system.factorise(kGamma));
    Eigen::VectorXd z = r;
    system.solve(z.data());
    return z;
  }

  /// (1 − γ ∂f/∂y) z by differences, without the energies.
  Eigen::VectorXd product(const Eigen::VectorXd& z) {
    constexpr double kMove = 1e-6;
    FirstOrderForm form(position.rows());
    Eigen::VectorXd y(form.size());
    form.pack({0.0, 0, position, PointArray::Zero(position.rows(), 2)}, y.data());
    Eigen::VectorXd above(form.size());
    Eigen::VectorXd below(form.size());
    const Eigen::VectorXd y_above = y + kMove * z;
    const Eigen::VectorXd y_below = y - kMove * z;
    form.evaluate(field, y_above.data(), above.data());
    form.evaluate(field, y_below.data(), below.data());
    Eigen::VectorXd product = z - kGamma * (above - below) / (2.0 * kMove);
    product.tail(2) = z.tail(2);
    return product;
  }

  Lattice lattice = triangular_patch(4);
  ForceField field{BondForces(lattice, {1.0, 0.5, 0.2}), 0.1};
  PointArray position;
};

Eigen::VectorXd some_residual(Eigen::Index points) {
  return Eigen::VectorXd::LinSpaced(4 * points + 2, -1.0, 1.0).array().sin();
}

/// Differences of the forces are good to the square of their step.
constexpr double kDifferences = 1e-8;

TEST(ReducedSystem, SolvesTheSystemOfPositionsAndVelocities) {
  Patch patch;
  const Eigen::VectorXd r = some_residual(16);
  EXPECT_LT((patch.product(patch.solved(r)) - r).cwiseAbs().maxCoeff(), kDifferences);
}

TEST(ReducedSystem, KeepsSupportedCoordinates) {
  Patch patch;
  patch.field.supports.emplace(std::vector<std::int32_t>{0, 5}, std::vector<std::int32_t>{3});
  Eigen::VectorXd r = some_residual(16);
  for (const int velocity : {32 + 0, 32 + 5, 48 + 3}) r(velocity) = r(velocity - 32) = 0.0;
  const Eigen::VectorXd z = patch.solved(r);
  EXPECT_LT((patch.product(z) - r).cwiseAbs().maxCoeff(), kDifferences);
  for (const int velocity : {32 + 0, 32 + 5, 48 + 3}) EXPECT_EQ(z(velocity), 0.0);
}

TEST(ReducedSystem, SolvesTheSystemWithTheRotationHeld) {
  Patch patch;
  patch.field.hold.emplace(patch.lattice.points);
  const Eigen::VectorXd r = some_residual(16);
  EXPECT_LT((patch.product(patch.solved(r)) - r).cwiseAbs().maxCoeff(), kDifferences);
}

}  // namespace
}  // namespace impact
