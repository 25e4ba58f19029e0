#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "measure/contact_time.hpp"

namespace impact {

/// What the wall did to the disk: the forces now, and their course since the report before.
struct ContactReport {
  struct PointForce {
    std::int32_t point;    ///< 0-based index
    Eigen::Array2d force;  ///< of the wall on the point, M c²/R
  };
  double time = 0.0;  ///< R/c
  std::uint64_t step = 0;
  std::vector<PointForce> points;                 ///< those in contact
  Eigen::Array2d total = Eigen::Array2d::Zero();  ///< of the wall on all points, M c²/R
  double impulse = 0.0;              ///< along y since the report before, trapezoidal rule, M c
  double peak_force = 0.0;           ///< along y since the report before, M c²/R
  std::vector<ForceSample> samples;  ///< of every step since the report before
};

}  // namespace impact
