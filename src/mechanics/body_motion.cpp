#include "mechanics/body_motion.hpp"

#include <cmath>

namespace impact {

BodyMotion body_motion(const Eigen::Ref<const PointArray>& position,
                       const Eigen::Ref<const PointArray>& velocity) {
  BodyMotion motion;
  motion.centre = position.colwise().mean();
  motion.velocity = velocity.colwise().mean();
  const PointArray arm = position.rowwise() - motion.centre.transpose();
  const auto points = static_cast<double>(position.rows());
  motion.angular_momentum =
      (arm.col(0) * velocity.col(1) - arm.col(1) * velocity.col(0)).sum() / points;
  motion.moment_of_inertia = arm.square().sum() / points;
  return motion;
}

double rigid_rotation(const PointArray& reference, const PointArray& position) {
  const PointArray from = reference.rowwise() - reference.colwise().mean();
  const double cross = (from.col(0) * position.col(1) - from.col(1) * position.col(0)).sum();
  const double dot = (from * position).sum();
  return std::atan2(cross, dot);
}

}  // namespace impact
