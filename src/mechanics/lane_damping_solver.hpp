#pragma once

#include <optional>

#include "kernels/panel_cholesky.hpp"
#include "mechanics/damping_solver.hpp"
#include "mechanics/lane_field.hpp"

namespace impact {

/// As DampingSolver, for runs in lanes that have the same damping and the same step.
class LaneDampingSolver {
 public:
  /// Empty lanes have the scale 0.
  void prepare(const LaneField& field, const LaneNumbers& scale);

  /// Overwrites r with u.
  void solve(LaneArray& velocity) { factor_->solve(velocity); }

 private:
  double scale_ = 0.0;
  std::optional<PanelCholesky> factor_;
};

}  // namespace impact
