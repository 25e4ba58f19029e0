#pragma once

#include "kernels/lanes.hpp"

namespace impact {

template <class Number>
Number zero();
template <>
inline double zero() {
  return 0.0;
}
template <>
inline LaneNumbers zero() {
  return LaneNumbers::Zero();
}

/// What leaves the motion: energy in M c², or power in M c³/R. Of one run or of kLanes runs.
template <class Number>
struct BasicLosses {
  Number dissipated = zero<Number>();  ///< by the damping of the bonds
  Number absorbed = zero<Number>();    ///< at the boundary of an elastic wall
};

using Losses = BasicLosses<double>;
using LaneLosses = BasicLosses<LaneNumbers>;

}  // namespace impact
