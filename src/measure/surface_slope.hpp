#pragma once

#include <vector>

#include "mechanics/contact.hpp"

namespace impact {

/// The slope dy/dx of the chord of a surface under what presses on it: from the first to the last
/// of the points of the surface that are pushed. NaN where fewer than two are.
/// @param pushed in the order of the surface, as from Contact::reactions()
double chord_slope(const std::vector<PointForce>& pushed, const ConstPoints& position);

/// By how much the surface under a contact is turned: the mean of its slope over the contact,
/// weighted by the impulse along y. Each slope stands for the time since the one before.
///
/// The slopes of the single bonds under the points in contact, weighted in the same way, need no
/// measure: each of these forces is normal to its bond, so that their mean is the impulse along −x
/// over that along y, −Restitution::impulse_ratio.
class SurfaceSlope {
 public:
  /// `time`: at which the contact has not begun, R/c.
  explicit SurfaceSlope(double time) : time_(time) {}

  /// In the order of time. A slope of NaN does not count.
  /// @param time R/c
  /// @param force along y, M c²/R
  void add(double time, double force, double slope);

  double mean() const { return moment_ / impulse_; }  ///< NaN where nothing was pushed

 private:
  double time_;
  double impulse_ = 0.0;  ///< M c
  double moment_ = 0.0;   ///< the same times the slope
};

}  // namespace impact
