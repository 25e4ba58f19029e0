#pragma once

#include <cstdint>
#include <vector>

#include "mechanics/force_field.hpp"
#include "run/second_body.hpp"
#include "scene/scene.hpp"

namespace impact {

/// The disk in the wall's place: the mirror image of the first one, from its file, or placed by the
/// first one's recipe with the same number density in a disk of wall.radius. Its randomness is
/// drawn from the scene's seed, apart from the first one's.
/// @throw InputError when the file cannot be used.
SecondBody second_disk(const Scene& scene, const Lattice& first);

/// Rows of the corners of the convex hull of these points, clockwise, the first one again at the
/// end. The first point has the row `first_row`.
std::vector<std::int32_t> closed_outline(const PointArray& points, Eigen::Index first_row);

/// Adds to the field the contact of the first disk with the second. `position` holds the points of
/// both.
void add_disk_contact(const Scene& scene, const Lattice& first, const SecondBody& second,
                      const Repulsion& law, const PointArray& position, ForceField& field);

}  // namespace impact
