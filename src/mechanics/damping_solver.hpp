#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "mechanics/force_field.hpp"

namespace impact {

/// Solves (1 + s D/m) u = r for the velocities u of all points, with the constant matrix D of the
/// field's damping. Where the field holds the rotation or supports coordinates, u keeps the
/// constraint.
///
/// Cholesky factor by Eigen (AMD ordering), once. The triangular solves are our own: x and y have
/// the same factor unless dashpots or supports tell them apart, and go through it together, which
/// is three times as fast as Eigen's column after column.
class DampingSolver {
 public:
  /// `scale`: s in R/c.
  DampingSolver(const ForceField& field, double scale);

  /// Overwrites r with u.
  void solve(PointArray& velocity);

 private:
  /// L of P A Pᵀ = L Lᵀ, column after column, without its diagonal, of which the inverse is kept.
  struct Factor {
    explicit Factor(const Eigen::SparseMatrix<double>& matrix);
    std::vector<std::int32_t> place;  ///< of each row in the order of elimination
    std::vector<std::int32_t> begin;  ///< of each column in `row` and `value`
    std::vector<std::int32_t> row;
    std::vector<double> value;
    std::vector<double> inverse_diagonal;
  };

  template <int kColumns>
  void substitute(const Factor& factor, int axis, PointArray& velocity);

  std::vector<Factor> factors_;  ///< one for both axes, or one for each
  std::vector<double> work_;
  PointArray hold_direction_;  ///< empty: rotation not held
  PointArray hold_response_;   ///< u for r = hold_direction_, over their product
};

}  // namespace impact
