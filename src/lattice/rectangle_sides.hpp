#pragma once

#include <cstdint>
#include <vector>

#include "lattice/lattice.hpp"

namespace impact {

/// The points along the sides of a lattice that fills a rectangle, by their indices: left and right
/// side upwards, bottom and top side to the right. A corner belongs to two sides.
struct RectangleSides {
  std::vector<std::int32_t> left;
  std::vector<std::int32_t> right;
  std::vector<std::int32_t> bottom;
  std::vector<std::int32_t> top;
};

/// The points whose coordinates are extreme, to 10⁻⁹ of the rectangle's size.
/// @throw InputError when the top side is not a chain of bonds.
RectangleSides rectangle_sides(const Lattice& lattice);

}  // namespace impact
