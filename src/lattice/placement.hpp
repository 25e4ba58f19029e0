#pragma once

#include <cstdint>

#include "lattice/lattice.hpp"

namespace impact {

enum class Placement {
  kUniform,   ///< independent uniform points
  kBlueNoise  ///< uniform points no closer than 0.6 s to each other, by dart throwing
};

/// How points are placed in the disk of radius 1 R about the origin. The typical spacing is
/// s = √(area/N) = √(π/N).
struct DiskRecipe {
  int points = 1099;  ///< N, at least 3, rim included
  Placement placement = Placement::kBlueNoise;
  bool rim = true;  ///< min(N, ⌊2π/s⌋) of the points evenly on the circle, turned by a random angle
};

/// Points of the recipe; the same seed gives the same points. O(N) time and memory.
PointArray place_in_disk(const DiskRecipe& recipe, std::uint64_t seed);

}  // namespace impact
