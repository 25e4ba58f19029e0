#pragma once

#include "lattice/lattice.hpp"

namespace impact {

/// @throw InputError when there are fewer than three points, or all lie on one line.
void require_area(const PointArray& points);

}  // namespace impact
