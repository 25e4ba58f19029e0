#pragma once

#include <cstdint>

#include "lattice/lattice.hpp"

namespace impact {

enum class Placement {
  kUniform,   ///< independent uniform points
  kBlueNoise  ///< uniform points no closer than 0.6 s to each other, by dart throwing
};

/// How points are placed in a region. The typical spacing is s = √(area/N).
struct PlacementRecipe {
  int points = 1099;  ///< N, at least 3, rim included
  Placement placement = Placement::kBlueNoise;
  bool rim = true;  ///< points evenly along the region's boundary, about s apart
};

/// Points of the recipe in the disk of radius 1 R about the origin; the same seed gives the same
/// points. The rim is min(N, ⌊2π/s⌋) points on the circle, turned by a random angle. O(N) time and
/// memory.
PointArray place_in_disk(const PlacementRecipe& recipe, std::uint64_t seed);

/// Points of the recipe in the rectangle of this width and height (R) about the origin; the same
/// seed gives the same points. The rim are points along the four sides, corners included, each side
/// in the whole number of equal intervals nearest to side/s (at least 1); their coordinates across
/// the side are exactly ±height/2 or ±width/2. O(N) time and memory.
/// @throw InputError when the rim needs more than N points.
PointArray place_in_rectangle(const PlacementRecipe& recipe, double width, double height,
                              std::uint64_t seed);

/// N points without a rim in the same rectangle repeated periodically in x and y: distances are
/// those to the nearest image, s = √(width·height/N). The same seed gives the same points.
PointArray place_in_periodic_rectangle(int points, Placement placement, double width, double height,
                                       std::uint64_t seed);

}  // namespace impact
