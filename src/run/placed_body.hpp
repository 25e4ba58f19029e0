#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lattice/lattice.hpp"
#include "lattice/rectangle_sides.hpp"

namespace impact {

/// Any constant will do that keeps the random numbers of the other bodies apart from the disk's.
constexpr std::uint64_t kSeedOfOtherBody = 0x9E3779B97F4A7C15;

/// A lattice where it lies before the first body is put above it: an elastic wall, its top side at
/// y = 0 and its middle at x = 0, or a disk of a row.
struct PlacedBody {
  Lattice lattice;
  RectangleSides sides{};            ///< of a wall
  std::vector<std::string> flags{};  ///< Run::flags() that its file leads to
};

}  // namespace impact
