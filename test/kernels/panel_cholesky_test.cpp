#include "kernels/panel_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "every_kernel.hpp"

namespace impact {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

PointArray some_columns(Eigen::Index size) {
  std::srand(7);
  return PointArray::Random(size, 2);
}

/// Of the norm-wise backward error |A u − b|/(|A| |u|) in largest row sums, which the sums of the
/// substitutions, of at most N terms, keep at some units of rounding.
double backward_error(const SparseMatrix& matrix, const PointArray& u, const PointArray& b) {
  const double largest_row = Eigen::MatrixXd(matrix).cwiseAbs().rowwise().sum().maxCoeff();
  const double residual = (matrix * u.matrix() - b.matrix()).cwiseAbs().maxCoeff();
  return residual / (largest_row * u.abs().maxCoeff()) / std::numeric_limits<double>::epsilon();
}

void expect_solved(const SparseMatrix& matrix, const Kernels& kernels) {
  const PointArray b = some_columns(matrix.rows());
  PanelCholesky cholesky(matrix, kernels);
  for (int repetition = 0; repetition < 2; ++repetition) {
    PointArray u = b;
    cholesky.solve(u);
    EXPECT_LT(backward_error(matrix, u, b), 10.0) << "N = " << matrix.rows();
  }
}

class EveryPanelKernel : public KernelTest {};

/// One supernode of every width.
TEST_P(EveryPanelKernel, SolvesDenseSystems) {
  for (Eigen::Index size = 1; size <= 13; ++size) {
    const Eigen::MatrixXd root = Eigen::MatrixXd::Random(size, size);
    const Eigen::MatrixXd matrix = root * root.transpose() + Eigen::MatrixXd::Identity(size, size);
    expect_solved(matrix.sparseView(), *GetParam());
  }
}

/// No supernode has rows below it.
TEST_P(EveryPanelKernel, DividesByADiagonal) {
  SparseMatrix matrix(9, 9);
  for (int i = 0; i < 9; ++i) matrix.insert(i, i) = std::ldexp(1.0, i - 4);
  const PointArray b = some_columns(9);
  PointArray u = b;
  PanelCholesky(matrix, *GetParam()).solve(u);
  for (int i = 0; i < 9; ++i) {
    // The root of an odd power of two is rounded, and so is its square.
    EXPECT_NEAR(u(i, 0), std::ldexp(b(i, 0), 4 - i), 1e-15 * std::ldexp(1.0, 4 - i));
    EXPECT_NEAR(u(i, 1), std::ldexp(b(i, 1), 4 - i), 1e-15 * std::ldexp(1.0, 4 - i));
  }
}

/// 1 + s L with the Laplacian L of a square grid, from nearly 1 to nearly singular: supernodes of
/// many widths, over each other.
TEST_P(EveryPanelKernel, SolvesSystemsOfAGrid) {
  constexpr int kSide = 23;
  for (const double scale : {1e-3, 1.0, 1e6}) {
    SparseMatrix matrix(kSide * kSide, kSide * kSide);
    matrix.setIdentity();
    const auto bond = [&](int i, int j) {
      matrix.coeffRef(i, i) += scale;
      matrix.coeffRef(j, j) += scale;
      matrix.coeffRef(i, j) -= scale;
      matrix.coeffRef(j, i) -= scale;
    };
    for (int i = 0; i < kSide * kSide; ++i) {
      if (i % kSide != 0) bond(i - 1, i);
      if (i >= kSide) bond(i - kSide, i);
    }
    expect_solved(matrix, *GetParam());
  }
}

/// Pieces without a bond between them: the elimination tree is a forest.
TEST_P(EveryPanelKernel, SolvesSystemsOfSeveralPieces) {
  SparseMatrix matrix(30, 30);
  matrix.setIdentity();
  for (int i = 0; i < 30; i += 3) {
    for (int k = 0; k < 3; ++k) matrix.coeffRef(i + k, i + k) += 2.0;
    for (int k = 0; k < 2; ++k) {
      matrix.coeffRef(i + k, i + k + 1) = -1.0;
      matrix.coeffRef(i + k + 1, i + k) = -1.0;
    }
  }
  expect_solved(matrix, *GetParam());
}

/// Which one is a matter of cost alone.
TEST_P(EveryPanelKernel, SolvesInAnyOrder) {
  constexpr int kSize = 20;
  SparseMatrix matrix(kSize, kSize);
  matrix.setIdentity();
  for (int i = 1; i < kSize; ++i) matrix.coeffRef(i, i / 2) = matrix.coeffRef(i / 2, i) = -0.3;
  matrix.coeffRef(0, 0) = 2.0;
  EliminationOrder backwards(kSize);
  for (int i = 0; i < kSize; ++i) backwards.indices()(i) = kSize - 1 - i;
  const PointArray b = some_columns(kSize);
  for (const EliminationOrder& order : {backwards, elimination_order(matrix)}) {
    PointArray u = b;
    PanelCholesky(matrix, order, *GetParam()).solve(u);
    EXPECT_LT(backward_error(matrix, u, b), 10.0);
  }
}

/// What is in one column does not touch the other.
TEST_P(EveryPanelKernel, SolvesEachColumnForItself) {
  SparseMatrix matrix(5, 5);
  matrix.setIdentity();
  for (int i = 0; i < 4; ++i) matrix.coeffRef(i, i + 1) = matrix.coeffRef(i + 1, i) = -0.4;
  PanelCholesky cholesky(matrix, *GetParam());
  PointArray both = some_columns(5);
  PointArray swapped = both.rowwise().reverse();
  PointArray alone = both;
  alone.col(1).setZero();
  cholesky.solve(both);
  cholesky.solve(swapped);
  cholesky.solve(alone);
  EXPECT_TRUE((both.col(0) == swapped.col(1)).all());
  EXPECT_TRUE((both.col(1) == swapped.col(0)).all());
  EXPECT_TRUE((both.col(0) == alone.col(0)).all());
  EXPECT_TRUE((alone.col(1) == 0.0).all());
}

/// The row that fills up the panels forgets what was not finite.
TEST_P(EveryPanelKernel, ForgetsWhatWasNotFinite) {
  SparseMatrix matrix(3, 3);
  matrix.setIdentity();
  PanelCholesky cholesky(matrix, *GetParam());
  PointArray lost = PointArray::Constant(3, 2, std::nan(""));
  cholesky.solve(lost);
  EXPECT_TRUE(lost.isNaN().all());
  const PointArray b = some_columns(3);
  PointArray u = b;
  cholesky.solve(u);
  EXPECT_TRUE((u == b).all());
}

/// Of every width of supernodes, each lane to the last bit.
TEST_P(EveryPanelKernel, SolvesTheSameInLanes) {
  constexpr int kSize = 37;
  SparseMatrix matrix(kSize, kSize);
  for (int i = 0; i < kSize; ++i) {
    matrix.insert(i, i) = 4.0 + i;
    if (i > 0) matrix.insert(i, i - 1) = matrix.insert(i - 1, i) = -0.9;
    if (i > 6) matrix.insert(i, i - 7) = matrix.insert(i - 7, i) = -0.6;
  }
  PanelCholesky solver(matrix, *GetParam());
  LaneArray lanes;
  lanes.resize(kSize);
  for (int k = 0; k < kLanes; ++k) {
    for (int i = 0; i < kSize; ++i) lanes.lane(k).row(i) << std::sin(i + k), std::cos(2 * i - k);
  }
  const LaneArray given = lanes;
  solver.solve(lanes);
  for (int k = 0; k < kLanes; ++k) {
    PointArray b = given.lane(k);
    solver.solve(b);
    EXPECT_TRUE((lanes.lane(k) == b).all()) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, EveryPanelKernel, all_kernels(), kernel_name);

}  // namespace
}  // namespace impact
