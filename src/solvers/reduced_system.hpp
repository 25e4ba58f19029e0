#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "mechanics/first_order_form.hpp"

namespace impact {

/// Solves the linear systems of implicit multistep methods, M z = r with M = 1 − γ ∂f/∂y for
/// y = (x, v, energies), reduced to the velocities:
///   (1 + γ D/m + γ² K/m) z_v = r_v − γ K r_x/m,   z_x = r_x + γ z_v,
/// with the damping matrix D and the tangent stiffness K. The energies do not act back on the
/// motion; M has the unit matrix in their place. Where the field holds the rotation, no force acts
/// along the direction d of the constraint, and d·z_v = d·r_v: errors along it must not survive the
/// solution, since nothing else would ever bring them back.
///
/// Sparse Cholesky factors (LDLᵀ) by Eigen, with the ordering of the first matrix.
class ReducedSystem {
 public:
  explicit ReducedSystem(const ForceField& field);

  /// Takes the stiffness at this position for all that follows.
  void set_stiffness(const ForceField& field, const PointArray& position);

  /// `gamma` in R/c. False when the matrix has no factors.
  bool factorise(double gamma);

  /// Overwrites r with z; r as FirstOrderForm's y.
  void solve(double* r);

 private:
  using Matrix = Eigen::SparseMatrix<double>;

  double point_mass_;
  double gamma_ = 0.0;
  Matrix damping_;    ///< of both axes, x before y
  Matrix stiffness_;  ///< with a place for each diagonal element
  Matrix sum_;
  Eigen::SimplicialLDLT<Matrix> factors_;
  bool ordered_ = false;
  Eigen::VectorXd pivots_;  ///< of the factors
  Eigen::VectorXd work_;
  Eigen::VectorXd hold_direction_;  ///< empty: rotation not held
  Eigen::VectorXd hold_response_;
};

}  // namespace impact
