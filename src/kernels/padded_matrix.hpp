#pragma once

#include <Eigen/Core>

#include "kernels/kernels.hpp"

namespace impact {

/// A dense matrix to multiply vectors with by kernels, its rows filled up with zeros.
class PaddedMatrix {
 public:
  PaddedMatrix() = default;
  explicit PaddedMatrix(const Eigen::MatrixXd& matrix);

  /// y = A x. y has rows() numbers, of which those that were filled up become 0.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;

  /// A multiple of kSlice.
  Eigen::Index rows() const { return values_.rows(); }

 private:
  const Kernels* kernels_ = &kernels();
  Eigen::MatrixXd values_;
};

}  // namespace impact
