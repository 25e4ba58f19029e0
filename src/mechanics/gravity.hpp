#pragma once

#include "mechanics/compression_load.hpp"

namespace impact {

/// The weight of the first body.
class Gravity : public CompressionLoad {
 public:
  static constexpr const char* kName = "gravity";

  /// `acceleration` in c²/R, of a body of so many points and the mass 1 M.
  Gravity(double acceleration, Eigen::Index points) : CompressionLoad(acceleration, points) {}
};

}  // namespace impact
