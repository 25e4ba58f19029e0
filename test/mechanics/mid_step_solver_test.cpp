#include "mechanics/mid_step_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "test_lattices.hpp"

namespace impact {
namespace {

constexpr double kBulkMass = 0.1;
constexpr double kBulkStiffness = 0.7;
constexpr int kBulkPoints = 16;

ForceField bulk(double eta) {
  ForceField field{BondForces(triangular_patch(4), {kBulkStiffness, 0.5, eta}), kBulkMass};
  field.unstrained = std::make_shared<const PointArray>(triangular_patch(4).points);
  return field;
}

/// x of all points, then y.
Eigen::VectorXd in_a_row(const PointArray& vectors) {
  Eigen::VectorXd row(2 * vectors.rows());
  row << vectors.col(0).matrix(), vectors.col(1).matrix();
  return row;
}

Eigen::MatrixXd laplacian() {
  const MatrixEntries entries = bulk(1.0).bonds.damping();
  Eigen::SparseMatrix<double> sparse(kBulkPoints, kBulkPoints);
  sparse.setFromTriplets(entries.begin(), entries.end());
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(2 * kBulkPoints, 2 * kBulkPoints);
  both.topLeftCorner(kBulkPoints, kBulkPoints) = sparse;
  both.bottomRightCorner(kBulkPoints, kBulkPoints) = sparse;
  return both;
}

/// K = k_a P L P.
Eigen::MatrixXd bound_of_stiffness() {
  const Eigen::VectorXd r = in_a_row(MidStepSolver(bulk(0.0)).rotation()).normalized();
  const Eigen::MatrixXd outside =
      Eigen::MatrixXd::Identity(2 * kBulkPoints, 2 * kBulkPoints) - r * r.transpose();
  return kBulkStiffness * outside * laplacian() * outside;
}

PointArray some_bulk_velocities() {
  std::srand(5);
  return PointArray::Random(kBulkPoints, 2);
}

struct BulkSolution {
  PointArray velocity = some_bulk_velocities();
  PointArray differences = PointArray(kBulkPoints, 2);
};

BulkSolution bulk_solution(const ForceField& field, double h) {
  MidStepSolver solver(field);
  solver.prepare(h);
  BulkSolution solution;
  solver.solve(solution.velocity, solution.differences);
  return solution;
}

/// A u = b by the whole matrix; and the damping's part of it by L u.
TEST(MidStepSolver, SolvesTheSystem) {
  for (const double eta : {0.0, 0.2, 50.0}) {
    for (const double h : {0.01, 1.0, 30.0}) {
      const Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(2 * kBulkPoints, 2 * kBulkPoints) +
                                     0.5 * h * eta / kBulkMass * laplacian() +
                                     0.25 * h * h / kBulkMass * bound_of_stiffness();
      const BulkSolution solution = bulk_solution(bulk(eta), h);
      const Eigen::VectorXd u = in_a_row(solution.velocity);
      // Sums of some ten terms, of that size at most.
      const double rounding = 1e-15 * 10.0 * matrix.cwiseAbs().maxCoeff();
      EXPECT_LT((matrix * u - in_a_row(some_bulk_velocities())).cwiseAbs().maxCoeff(), rounding)
          << eta << " " << h;
      EXPECT_LT((laplacian() * u - in_a_row(solution.differences)).cwiseAbs().maxCoeff(),
                1e-13 * std::max(1.0, 1.0 / h))
          << eta << " " << h;
      EXPECT_GT((in_a_row(some_bulk_velocities()) - u).cwiseAbs().maxCoeff(), 1e-3);
    }
  }
}

/// What a step by it is stable by: no displacement costs more energy in bonds than in K.
TEST(MidStepSolver, BoundsTheStiffnessOfTheUnstrainedBonds) {
  const MatrixEntries entries = bulk(0.0).bonds.stiffness(triangular_patch(4).points);
  Eigen::SparseMatrix<double> bonds(2 * kBulkPoints, 2 * kBulkPoints);
  bonds.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> excess(bound_of_stiffness() -
                                                              Eigen::MatrixXd(bonds));
  EXPECT_GT(excess.eigenvalues().minCoeff(), -1e-14);
  EXPECT_GT(excess.eigenvalues().maxCoeff(), 1.0);
}

/// However long the step: what goes through the factor would lose c |L|, here 10¹⁵, spacings.
TEST(MidStepSolver, LeavesRigidMotionToItselfWithoutDamping) {
  MidStepSolver solver(bulk(0.0));
  solver.prepare(1e7);
  PointArray velocity = 0.2 * solver.rotation();
  velocity.col(0) += 0.3;
  velocity.col(1) -= 0.1;
  const PointArray rigid = velocity;
  PointArray differences(kBulkPoints, 2);
  solver.solve(velocity, differences);
  EXPECT_LT((velocity - rigid).abs().maxCoeff(), 1e-15);
}

/// With the constraint's direction c and a multiplier λ, A u = b + λ c and c · u = 0.
TEST(MidStepSolver, KeepsTheRotationHeld) {
  constexpr double kStep = 3.0;
  constexpr double kEta = 0.2;
  ForceField field = bulk(kEta);
  field.hold.emplace(triangular_patch(4).points);
  const BulkSolution solution = bulk_solution(field, kStep);
  const Eigen::VectorXd u = in_a_row(solution.velocity);
  const Eigen::VectorXd c = in_a_row(field.hold->direction());
  EXPECT_NEAR(c.dot(u), 0.0, 1e-13);
  EXPECT_NEAR(c.dot(in_a_row(solution.differences)), 0.0, 1e-13);
  const Eigen::VectorXd excess = u + 0.5 * kStep * kEta / kBulkMass * (laplacian() * u) +
                                 0.25 * kStep * kStep / kBulkMass * (bound_of_stiffness() * u) -
                                 in_a_row(some_bulk_velocities());
  const double multiplier = c.dot(excess) / c.squaredNorm();
  EXPECT_GT(std::abs(multiplier), 1e-3);
  EXPECT_LT((excess - multiplier * c).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(MidStepSolver, WantsUnstrainedPositionsAndNoSupports) {
  ForceField field = bulk(0.1);
  field.supports.emplace(std::vector<std::int32_t>{0}, std::vector<std::int32_t>{5});
  EXPECT_THROW(MidStepSolver{field}, std::invalid_argument);
  field.supports.reset();
  field.unstrained.reset();
  EXPECT_THROW(MidStepSolver{field}, std::invalid_argument);
}

}  // namespace
}  // namespace impact
