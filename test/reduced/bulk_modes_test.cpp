#include "reduced/bulk_modes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>

#include "small_disk.hpp"

namespace impact {
namespace {

/// Rounding of sums over some hundred numbers of size 1, and what the modes' shapes inherit from
/// vectors that were nearly in the space before them.
constexpr double kRounding = 1e-9;

Eigen::SparseMatrix<double> matrix_of(const MatrixEntries& entries, Eigen::Index size) {
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

class DiskModes : public testing::Test {
 protected:
  SmallDisk disk_{150};
  BulkModes modes_ = bulk_modes(disk_.lattice, *disk_.compliance, kA);
  Eigen::Index n_ = disk_.lattice.points.rows();
  Eigen::Index size_ = modes_.stiffness.size();
  double mass_ = 1.0 / static_cast<double>(n_);  ///< of a point
};

TEST_F(DiskModes, AreOrthonormalAndMoveNoCentre) {
  const Eigen::MatrixXd product = modes_.shapes.transpose() * modes_.shapes * mass_;
  EXPECT_LT((product - Eigen::MatrixXd::Identity(size_, size_)).cwiseAbs().maxCoeff(), kRounding);
  EXPECT_LT(modes_.shapes.topRows(n_).colwise().mean().cwiseAbs().maxCoeff(), kRounding);
  EXPECT_LT(modes_.shapes.bottomRows(n_).colwise().mean().cwiseAbs().maxCoeff(), kRounding);
  EXPECT_LT(size_, n_);
}

TEST_F(DiskModes, ProjectStiffnessAndDamping) {
  const BondForces bonds(disk_.lattice, {1.0, 0.0, 1.0});
  const auto k = matrix_of(bonds.stiffness(disk_.lattice.points), 2 * n_);
  const auto l = matrix_of(bonds.damping(), n_);
  const Eigen::MatrixXd stiffness = modes_.shapes.transpose() * (k * modes_.shapes);
  const Eigen::MatrixXd x = modes_.shapes.topRows(n_);
  const Eigen::MatrixXd y = modes_.shapes.bottomRows(n_);
  const Eigen::MatrixXd damping = x.transpose() * (l * x) + y.transpose() * (l * y);
  const double largest = modes_.stiffness.maxCoeff();
  const Eigen::MatrixXd diagonal = modes_.stiffness.asDiagonal();
  EXPECT_LT((stiffness - diagonal).cwiseAbs().maxCoeff(), kRounding * largest);
  EXPECT_LT((modes_.damping - damping).cwiseAbs().maxCoeff(), kRounding * largest);
  EXPECT_EQ(modes_.stiffness(0), 0.0);
  EXPECT_GT(modes_.stiffness(1), 1.0);
}

/// Nothing gains by damping.
TEST_F(DiskModes, ArePassive) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(modes_.damping);
  EXPECT_GT(solver.eigenvalues()(0), 0.0);
}

/// What the lowest points do under slow forces, and what the damping of that does.
TEST_F(DiskModes, HoldTheResponseOfTheLowestPoints) {
  const auto l = matrix_of(BondForces(disk_.lattice, {1.0, 0.0, 1.0}).damping(), n_);
  for (std::size_t k = 0; k < 3; ++k) {
    PointArray load = PointArray::Zero(2 * n_, 2);
    load(n_ + modes_.points[k], 0) = 1.0;
    for (const double part : {1e-2, 5e-2}) {
      disk_.compliance->respond(load);
      const Eigen::VectorXd u = load.col(0).matrix();
      const Eigen::VectorXd rest = u - modes_.shapes * (modes_.shapes.transpose() * u) * mass_;
      EXPECT_LT(rest.norm(), part * u.norm()) << k;
      load.col(0).head(n_) = (l * u.head(n_)).array();
      load.col(0).tail(n_) = (l * u.tail(n_)).array();
    }
  }
}

TEST_F(DiskModes, KnowWhatTurns) {
  Eigen::MatrixXd turned(2 * n_, size_);
  turned << -modes_.shapes.bottomRows(n_), modes_.shapes.topRows(n_);
  const Eigen::MatrixXd turning = modes_.shapes.transpose() * turned * mass_;
  EXPECT_LT((modes_.turning - turning).cwiseAbs().maxCoeff(), kRounding);
  EXPECT_NEAR(modes_.reach(0), 0.0, kRounding);
  EXPECT_NEAR(modes_.inertia, modes_.arm.square().sum() * mass_, 1e-12);
}

TEST_F(DiskModes, AreKeptForTheLatestWall) {
  BulkModesOnDemand on_demand;
  ComplianceOnDemand compliance;
  const auto first = on_demand.of(disk_.lattice, compliance, kA);
  EXPECT_EQ(on_demand.of(disk_.lattice, compliance, kA), first);
  const auto other = on_demand.of(disk_.lattice, compliance, 2.0 * kA);
  EXPECT_LT(other->points.size(), first->points.size());
  const auto again = on_demand.of(disk_.lattice, compliance, kA);
  EXPECT_TRUE((again->shapes.array() == first->shapes.array()).all());
}

}  // namespace
}  // namespace impact
