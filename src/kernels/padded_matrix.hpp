#pragma once

#include <Eigen/Core>

#include "kernels/kernels.hpp"

namespace impact {

/// A dense matrix to multiply with by kernels, its rows filled up with zeros to a multiple of
/// kSlice.
class PaddedMatrix {
 public:
  PaddedMatrix() = default;
  explicit PaddedMatrix(const Eigen::MatrixXd& matrix, const Kernels& kernels = impact::kernels());

  /// y = A x, with zeros in the rows that were filled up.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;
  /// A x, without those rows.
  Eigen::MatrixXd operator*(const Eigen::MatrixXd& x) const;

 private:
  DenseMatrix matrix() const { return {values_.data(), values_.rows(), values_.cols()}; }

  const Kernels* kernels_ = nullptr;
  Eigen::Index rows_ = 0;
  Eigen::MatrixXd values_;
};

}  // namespace impact
