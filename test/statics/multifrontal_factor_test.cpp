#include "statics/multifrontal_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <cmath>

#include "mechanics/bond_forces.hpp"
#include "statics/tied_stiffness.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

Matrix lower_triangle(const Matrix& matrix) { return matrix.triangularView<Eigen::Lower>(); }

/// Two springs in a row, the first end held in x and all in y: by hand.
TEST(MultifrontalFactor, OfTwoSpringsInARow) {
  Matrix lower(6, 6);
  lower.insert(0, 0) = 1.0 + 2.0;
  lower.insert(1, 0) = -2.0;
  lower.insert(1, 1) = 2.0 + 4.0;
  lower.insert(2, 1) = -4.0;
  lower.insert(2, 2) = 4.0;
  for (int i = 3; i < 6; ++i) lower.insert(i, i) = 1.0;
  lower.makeCompressed();
  PointArray points(3, 2);
  points << 0, 0, 1, 0, 2, 0;
  MultifrontalFactor factor(lower, points);
  factor.factorise(lower, 0.0);
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(6);
  pull << 0, 0, 4, 1, 2, 3;
  Eigen::VectorXd expected(6);
  expected << 4, 4 + 2, 4 + 2 + 1, 1, 2, 3;
  EXPECT_LT((factor.solve(pull) - expected).cwiseAbs().maxCoeff(), 1e-14);
}

/// Fronts of several blocks of columns, at random values on and above the diagonal; with a shift.
TEST(MultifrontalFactor, SolvesAsEigenDoes) {
  const Lattice patch = triangular_patch(60);
  std::srand(1);
  Matrix matrix = tied_stiffness(patch);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(matrix.rows());
  Matrix lower = lower_triangle(matrix);
  MultifrontalFactor factor(lower, patch.points);
  for (const double shift : {0.0, 0.1}) {
    Matrix shifted = matrix;
    shifted.diagonal().array() += shift;
    const Eigen::VectorXd expected = Eigen::SimplicialLDLT<Matrix>(shifted).solve(b);
    factor.factorise(lower, shift);
    // Rounding times the condition number, about the square of the side.
    EXPECT_LT((factor.solve(b) - expected).norm(), 1e-11 * expected.norm()) << shift;
  }
}

/// Other values at the same places, some of them negative: no positive definite matrix.
TEST(MultifrontalFactor, SolvesWithNegativeEigenvalues) {
  const Lattice patch = triangular_patch(20);
  Matrix lower = lower_triangle(tied_stiffness(patch));
  MultifrontalFactor factor(lower, patch.points);
  factor.factorise(lower, 0.0);
  for (Eigen::Index i = 0; i < lower.rows(); i += 3) lower.coeffRef(i, i) -= 7.0;
  factor.factorise(lower, 0.0);
  const Eigen::MatrixXd dense = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
  ASSERT_LT(dense.selfadjointView<Eigen::Lower>().eigenvalues()(0), -1.0);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(lower.rows(), -1.0, 1.0);
  const Eigen::VectorXd expected = dense.partialPivLu().solve(b);
  // Without pivoting the factors may grow, here by less than 10³.
  EXPECT_LT((factor.solve(b) - expected).norm(), 1e-11 * expected.norm());
}

/// A free lattice can be shifted: no number.
TEST(MultifrontalFactor, HasNoSolutionOfASingularMatrix) {
  Matrix lower(6, 6);
  for (int i = 0; i < 6; ++i) lower.insert(i, i) = i == 2 ? 0.0 : 1.0;
  lower.makeCompressed();
  MultifrontalFactor factor(lower, triangle().points);
  factor.factorise(lower, 0.0);
  EXPECT_FALSE(factor.solve(Eigen::VectorXd::Ones(6)).allFinite());
}

}  // namespace
}  // namespace impact
