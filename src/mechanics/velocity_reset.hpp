#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "mechanics/force_term.hpp"

namespace impact {

/// The energy-absorbing boundary of §5 of the paper: the velocities of the boundary's points are
/// set to zero at fixed intervals of time. The paper does so at every step of its integrator; then
/// the answer depends on the step, and as the step goes to zero the boundary becomes a clamp.
class VelocityReset : public ForceTerm {
 public:
  static constexpr const char* kName = "velocity reset";
  static constexpr bool kInLanes = true;

  /// `interval` in R/c, a multiple of the integrator's step.
  VelocityReset(std::vector<std::int32_t> points, double interval)
      : points_(std::move(points)), interval_(interval) {}

  double interval() const { return interval_; }

  /// Returns the kinetic energy that is absorbed (M c²).
  double apply(Points velocity, double point_mass) const {
    double squared_speed = 0.0;
    for (const std::int32_t point : points_) {
      squared_speed += velocity.row(point).square().sum();
      velocity.row(point).setZero();
    }
    return 0.5 * point_mass * squared_speed;
  }

 private:
  std::vector<std::int32_t> points_;
  double interval_;
};

}  // namespace impact
