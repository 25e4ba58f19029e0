#pragma once

#include <Eigen/Core>

#include "mechanics/state.hpp"

namespace impact {

/// Motion of a body of equal mass points as a whole; its mass is 1 M.
struct BodyMotion {
  Eigen::Array2d centre{0.0, 0.0};    ///< of mass, R
  Eigen::Array2d velocity{0.0, 0.0};  ///< of the centre of mass, c
  double angular_momentum = 0.0;      ///< about the centre of mass, counter-clockwise, M c R
  double moment_of_inertia = 0.0;     ///< about the centre of mass, M R²
  double spin() const { return angular_momentum / moment_of_inertia; }  ///< c/R
};

BodyMotion body_motion(const Eigen::Ref<const PointArray>& position,
                       const Eigen::Ref<const PointArray>& velocity);

/// Positions as seen from the centre of mass.
inline PointArray about_the_centre(const ConstPoints& position) {
  return position.rowwise() - position.colwise().mean();
}

/// Angle (rad, counter-clockwise, -π … π) of the rigid rotation that brings `reference` closest to
/// `position` in the sense of least squares, both taken about their centres of mass.
double rigid_rotation(const PointArray& reference, const PointArray& position);

}  // namespace impact
