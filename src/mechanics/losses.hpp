#pragma once

#include "mechanics/lanes.hpp"

namespace impact {

inline void set_zero(double& number) { number = 0.0; }
inline void set_zero(LaneNumbers& numbers) { numbers.setZero(); }

/// What leaves the motion: energy in M c², or power in M c³/R. Of one run or of kLanes runs.
template <class Number>
struct BasicLosses {
  BasicLosses() {
    set_zero(dissipated);
    set_zero(absorbed);
  }
  BasicLosses(const Number& by_bonds, const Number& at_boundary)
      : dissipated(by_bonds), absorbed(at_boundary) {}

  Number dissipated;  ///< by the damping of the bonds
  Number absorbed;    ///< at the boundary of an elastic wall
};

using Losses = BasicLosses<double>;
using LaneLosses = BasicLosses<LaneNumbers>;

}  // namespace impact
