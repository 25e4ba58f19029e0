#pragma once

#include <vector>

#include "mechanics/force_field.hpp"
#include "mechanics/panel_cholesky.hpp"

namespace impact {

/// Solves (1 + s D/m) u = r for the velocities u of all points, with the constant matrix D of the
/// field's damping. Where the field holds the rotation or supports coordinates, u keeps the
/// constraint.
///
/// x and y have the same Cholesky factor unless dashpots or supports tell them apart, and go
/// through it together.
class DampingSolver {
 public:
  /// `scale`: s in R/c.
  DampingSolver(const ForceField& field, double scale);

  /// Overwrites r with u.
  void solve(PointArray& velocity);

 private:
  std::vector<PanelCholesky> factors_;  ///< one for both axes, or one for each
  PointArray y_solution_;               ///< with the factor of the y axis, where it has its own
  PointArray hold_direction_;           ///< empty: rotation not held
  PointArray hold_response_;            ///< u for r = hold_direction_, over their product
};

}  // namespace impact
