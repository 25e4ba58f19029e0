#pragma once

#include <cstdint>

#include "mechanics/force_field.hpp"
#include "run/placed_body.hpp"
#include "scene/scene.hpp"

namespace impact {

/// The wall of the scene: from its file, or placed by the disk's recipe, with a rim, in a rectangle
/// of the disk's number density unless width and height say otherwise. Its randomness is drawn from
/// the scene's seed, apart from the disk's.
/// @throw InputError when the file cannot be used, or the wall has too few points for its sides.
PlacedBody elastic_wall_body(const Scene& scene, Eigen::Index disk_points);

/// Adds to the field the contact of the disk with the wall and what happens at the wall's left,
/// right and bottom side. `position` holds the disk's points and, after them, the wall's.
void add_elastic_wall(const Scene& scene, const PlacedBody& wall, const Repulsion& law,
                      const PointArray& position, ForceField& field);

/// Dashpots on the wall's left, right and bottom side, matched to the waves of the triangular
/// lattice of its density: ρ c_L and ρ c_T times the length of boundary that belongs to a point,
/// with ρ c_L² = 1.299 k_a and ρ c_T² = 0.433 k_a. The wall's first point has the row `first_row`.
ViscousBoundary viscous_boundary(const PlacedBody& wall, double point_mass, double k_a,
                                 std::int32_t first_row);

}  // namespace impact
