#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "measure/contact_time.hpp"
#include "mechanics/contact.hpp"

namespace impact {

/// What one body did to the other: the forces now, and their course since the report before.
struct ContactReport {
  double time = 0.0;  ///< R/c
  std::uint64_t step = 0;
  std::vector<PointForce> points;                 ///< those in contact
  Eigen::Array2d total = Eigen::Array2d::Zero();  ///< on all points, M c²/R
  double impulse = 0.0;              ///< along y since the report before, trapezoidal rule, M c
  double peak_force = 0.0;           ///< along y since the report before, M c²/R
  std::vector<ForceSample> samples;  ///< of every step since the report before
};

}  // namespace impact
