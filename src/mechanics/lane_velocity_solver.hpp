#pragma once

#include <optional>

#include "kernels/panel_cholesky.hpp"
#include "mechanics/lane_field.hpp"
#include "mechanics/velocity_solver.hpp"

namespace impact {

/// As VelocitySolver, for runs in lanes that have the same damping, supports and step.
class LaneVelocitySolver {
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
