#include "kernels/padded_matrix.hpp"

#include "every_kernel.hpp"

namespace impact {
namespace {

class EveryProductKernel : public KernelTest {};

/// Sums of up to 40 products of numbers below 1, in any order. Rows for each number of vectors
/// that go together and several sets of them, and sides with and without a rest.
TEST_P(EveryProductKernel, MultipliesAsEigenDoes) {
  constexpr double kRounding = 1e-14;
  std::srand(1);
  for (int rows = 1; rows < 150; rows += rows < 40 ? 1 : 7) {
    for (const int columns : {1, 2, 40}) {
      const Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(rows, columns);
      const PaddedMatrix padded(matrix, *GetParam());
      for (const int sides : {1, 3, 4, 9}) {
        const Eigen::MatrixXd x = Eigen::MatrixXd::Random(columns, sides);
        const Eigen::MatrixXd y = padded * x;
        ASSERT_EQ(y.rows(), rows);
        EXPECT_LE((y - matrix * x).cwiseAbs().maxCoeff(), kRounding) << rows << " " << sides;
      }
      const Eigen::VectorXd x = Eigen::VectorXd::Random(columns);
      Eigen::VectorXd y;
      padded.multiply(x, y);
      ASSERT_EQ(y.size(), (rows + kSlice - 1) / kSlice * kSlice);
      EXPECT_LE((y.head(rows) - matrix * x).cwiseAbs().maxCoeff(), kRounding) << rows;
      EXPECT_EQ(y.tail(y.size() - rows).cwiseAbs().sum(), 0.0) << rows;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, EveryProductKernel, all_kernels(), kernel_name);

}  // namespace
}  // namespace impact
