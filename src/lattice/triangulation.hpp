#pragma once

#include <vector>

#include "lattice/lattice.hpp"

namespace impact {

/// The edges of the Delaunay triangulation of the points (CGAL, exact predicates), each once with
/// `first < second`, sorted. The same points give the same bonds. O(N log N).
/// @throw InputError when two points coincide.
std::vector<Bond> delaunay_bonds(const PointArray& points);

}  // namespace impact
