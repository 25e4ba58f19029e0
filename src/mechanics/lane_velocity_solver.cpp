#include "mechanics/lane_velocity_solver.hpp"

namespace impact {

void LaneVelocitySolver::prepare(const LaneField& field, const LaneNumbers& scale) {
  const double common = scale.maxCoeff();
  if (common == scale_) return;
  scale_ = common;
  factor_.emplace(damping_matrix(field.latest(), 0, common),
                  field.latest().bonds.elimination_order());
}

}  // namespace impact
