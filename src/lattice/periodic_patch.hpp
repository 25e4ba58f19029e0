#pragma once

#include <cstdint>
#include <vector>

#include "lattice/lattice.hpp"
#include "lattice/placement.hpp"

namespace impact {

/// A piece of an endless lattice: the rectangle of this width and height (R) about the origin,
/// repeated in x and y. A bond that crosses a side joins its first point to an image of its second.
struct PeriodicPatch {
  PointArray points;
  std::vector<Bond> bonds;  ///< each pair once, 3 N in all
  PointArray
      bond_vectors;  ///< r_first − r_second, to the image that the bond joins; one row a bond
  double width;
  double height;
};

/// Joins the points along the edges of the Delaunay triangulation of the points and all their
/// images. The same points give the same bonds.
/// @throw InputError when two points coincide, and when a bond spans half the width or height: a
/// pair could then be bonded through two images (a few tens of points are enough to avoid it).
PeriodicPatch triangulated_patch(PointArray points, double width, double height);

/// The triangulated patch of place_in_periodic_rectangle().
PeriodicPatch random_patch(int points, Placement placement, double width, double height,
                           std::uint64_t seed);

}  // namespace impact
