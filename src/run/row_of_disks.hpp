#pragma once

#include <cstdint>
#include <vector>

#include "mechanics/force_field.hpp"
#include "run/placed_body.hpp"
#include "scene/scene.hpp"

namespace impact {

/// The disks in the wall's place, one below another, the top of the uppermost at y = 0 and that of
/// each other as high as the lowest point of the one above it: each the mirror image of the one
/// above, or from the file, or placed by the first disk's recipe with the same number density in a
/// disk of wall.radius. Their randomness is drawn from the scene's seed, apart from the first
/// disk's.
/// @throw InputError when the file cannot be used.
std::vector<PlacedBody> row_of_disks(const Scene& scene, const Lattice& first);

/// Rows of the corners of the convex hull of these points, clockwise, the first one again at the
/// end. The first point has the row `first_row`.
std::vector<std::int32_t> closed_outline(const PointArray& points, Eigen::Index first_row);

}  // namespace impact
