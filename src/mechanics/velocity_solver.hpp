#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "kernels/panel_cholesky.hpp"
#include "mechanics/force_field.hpp"

namespace impact {

/// 1 + s D/m with the damping D along one axis (0: x, 1: y), see ForceField::damping(); s in R/c.
Eigen::SparseMatrix<double> damping_matrix(const ForceField& field, int axis, double scale);

/// Solves (1 + s D/m) u = r for the velocities u of all points, with the constant matrix D of the
/// field's damping. Where the field holds the rotation or supports coordinates, u keeps the
/// constraint.
///
/// x and y have the same Cholesky factor unless dashpots or supports tell them apart, and go
/// through it together.
class VelocitySolver {
 public:
  /// Factorises the matrix of this field with this s (R/c), unless it has done so last.
  void prepare(const ForceField& field, double scale);

  /// Overwrites r with u.
  void solve(PointArray& velocity);

 private:
  void factorise(const ForceField& field, double scale);

  double scale_ = 0.0;
  std::vector<PanelCholesky> factors_;  ///< one for both axes, or one for each
  PointArray y_solution_;               ///< with the factor of the y axis, where it has its own
  PointArray hold_direction_;           ///< empty: rotation not held
  PointArray hold_response_;            ///< u for r = hold_direction_, over their product
};

}  // namespace impact
