#include "measure/surface_slope.hpp"

#include <cmath>
#include <limits>

namespace impact {

double chord_slope(const std::vector<PointForce>& pushed, const ConstPoints& position) {
  if (pushed.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  const auto first = position.row(pushed.front().point);
  const auto last = position.row(pushed.back().point);
  return (last.y() - first.y()) / (last.x() - first.x());
}

void SurfaceSlope::add(double time, double force, double slope) {
  const double impulse = force * (time - time_);
  time_ = time;
  if (std::isnan(slope)) return;
  impulse_ += impulse;
  moment_ += impulse * slope;
}

}  // namespace impact
