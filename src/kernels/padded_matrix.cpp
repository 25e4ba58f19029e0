#include "kernels/padded_matrix.hpp"

namespace impact {

PaddedMatrix::PaddedMatrix(const Eigen::MatrixXd& matrix)
    : values_((matrix.rows() + kSlice - 1) / kSlice * kSlice, matrix.cols()) {
  values_.topRows(matrix.rows()) = matrix;
  values_.bottomRows(values_.rows() - matrix.rows()).setZero();
}

void PaddedMatrix::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  y.resize(rows());
  kernels_->multiply({values_.data(), values_.rows(), values_.cols()}, x.data(), y.data());
}

}  // namespace impact
