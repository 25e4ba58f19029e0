#include "statics/compliance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include "mechanics/body_motion.hpp"
#include "mechanics/bond_forces.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

/// Half of a force on one end of a bond of stiffness 1 goes into their common motion; the other
/// half draws each end a quarter out.
TEST(Compliance, OfTwoPoints) {
  Compliance compliance(two_points());
  const PointCompliance both = compliance.among({0, 1});
  EXPECT_NEAR(both.xx(0, 0), 0.25, 1e-14);
  EXPECT_NEAR(both.xx(0, 1), -0.25, 1e-14);
  EXPECT_NEAR(both.xx(1, 1), 0.25, 1e-14);
  EXPECT_LT(both.yy.cwiseAbs().maxCoeff() + both.xy.cwiseAbs().maxCoeff(), 1e-14);
}

Eigen::MatrixXd pseudo_inverse(const Lattice& lattice) {
  const Eigen::Index n = lattice.points.rows();
  const auto entries = BondForces(lattice, {1.0, 0.0, 0.0}).stiffness(lattice.points);
  Eigen::SparseMatrix<double> stiffness(2 * n, 2 * n);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(1e-10);
  return decomposition.compute(Eigen::MatrixXd(stiffness)).pseudoInverse();
}

/// The projection on what is no rigid motion is that on the range of K.
TEST(Compliance, IsThePseudoInverseOfTheStiffness) {
  const Lattice patch = triangular_patch(4, 3);
  const Eigen::Index n = patch.points.rows();
  const Eigen::MatrixXd expected = pseudo_inverse(patch);
  Compliance compliance(patch);
  const std::vector<std::int32_t> points{7, 2, 11};
  const PointCompliance among = compliance.among(points);
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      const std::int32_t row = points[static_cast<std::size_t>(i)];
      const std::int32_t column = points[static_cast<std::size_t>(j)];
      EXPECT_NEAR(among.xx(i, j), expected(row, column), 1e-12);
      EXPECT_NEAR(among.xy(i, j), expected(row, n + column), 1e-12);
      EXPECT_NEAR(among.yy(i, j), expected(n + row, n + column), 1e-12);
    }
  }
  PointArray loads = PointArray::Random(2 * n, 2);
  const Eigen::MatrixXd displacements = expected * loads.matrix();
  compliance.respond(loads);
  EXPECT_LT((loads.matrix() - displacements).cwiseAbs().maxCoeff(), 1e-12);
}

/// Whether a point was asked for before or after another.
TEST(Compliance, DoesNotDependOnTheOrderOfQuestions) {
  const Lattice patch = triangular_patch(4, 3);
  Compliance one(patch);
  Compliance other(patch);
  one.among({1, 2, 3});
  other.among({3, 2});
  const PointCompliance a = one.among({2, 3, 1});
  const PointCompliance b = other.among({2, 3, 1});
  EXPECT_LT((a.xx - b.xx).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LT((a.xy - b.xy).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LT((a.yy - b.yy).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Compliance, IsMadeOnce) {
  ComplianceOnDemand on_demand;
  const auto first = on_demand.of(two_points());
  EXPECT_EQ(on_demand.of(triangle()), first);
}

}  // namespace
}  // namespace impact
