#include "mechanics/lane_damping_solver.hpp"

namespace impact {

void LaneDampingSolver::prepare(const LaneField& field, const LaneNumbers& scale) {
  const double common = scale.maxCoeff();
  if (common == scale_) return;
  scale_ = common;
  factor_.emplace(damping_matrix(field.latest(), 0, common));
}

}  // namespace impact
