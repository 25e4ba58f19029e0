#pragma once

#include <numeric>
#include <vector>

namespace impact {

/// Of one component of all points; NaN of none.
inline double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace impact
