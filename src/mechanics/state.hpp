#pragma once

#include <cstdint>

#include "lattice/lattice.hpp"

namespace impact {

/// Where every point is and how it moves. Lengths in R, speeds in c, time in R/c.
struct State {
  double time = 0.0;
  std::uint64_t step = 0;  ///< steps of the integrator since the start
  PointArray position;
  PointArray velocity;
};

}  // namespace impact
