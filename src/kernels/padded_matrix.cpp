#include "kernels/padded_matrix.hpp"

namespace impact {

PaddedMatrix::PaddedMatrix(const Eigen::MatrixXd& matrix, const Kernels& kernels)
    : kernels_(&kernels),
      rows_(matrix.rows()),
      values_(kSlice * whole_slices(matrix.rows()), matrix.cols()) {
  values_.topRows(rows_) = matrix;
  values_.bottomRows(values_.rows() - rows_).setZero();
}

void PaddedMatrix::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  y.resize(values_.rows());
  kernels_->multiply(matrix(), x.data(), 1, y.data());
}

Eigen::MatrixXd PaddedMatrix::operator*(const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd y(values_.rows(), x.cols());
  kernels_->multiply(matrix(), x.data(), x.cols(), y.data());
  return y.topRows(rows_);
}

}  // namespace impact
