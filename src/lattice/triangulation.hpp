#pragma once

#include <cstdint>
#include <vector>

#include "lattice/lattice.hpp"

namespace impact {

/// The points in the order in which a Hilbert curve visits them (CGAL, median policy): neighbours
/// in it are near each other. O(N log N).
std::vector<std::int32_t> hilbert_order(const PointArray& points);

/// The edges of the Delaunay triangulation of the points (CGAL, exact predicates), each once with
/// `first < second`, sorted. The same points give the same bonds. O(N log N).
/// @throw InputError when two points coincide.
std::vector<Bond> delaunay_bonds(const PointArray& points);

/// The same of points that follow each other as in hilbert_order(): of others it takes longer.
std::vector<Bond> delaunay_bonds_in_order(const PointArray& points);

}  // namespace impact
