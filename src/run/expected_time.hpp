#pragma once

#include <Eigen/Core>

#include "mechanics/potential_wall.hpp"
#include "scene/scene.hpp"

/// What can be said of a scene's motion before it is made.
namespace impact {

/// √(E/ρ) (c) with E of the triangular lattice, 2/√3 k_a, and the density M/(πR²): close to what
/// random lattices have (E = 1.04 … 1.1 k_a).
double estimated_sound_speed(double k_a);

/// The repulsion of the scene's wall, whichever it has, for a disk of so many points.
PotentialWall repulsion(const Scene& scene, Eigen::Index points);

/// Contact::moving_ends() of the scene's contact.
double moving_ends(const Scene& scene);

/// Along y at the start, in M c²; of two bodies with this reduced mass (M).
double impact_energy(const Scene& scene, double reduced_mass);

/// The energy of the potential wall that counts as none: numerics.error/100 of the kinetic energy
/// along y at the start. In M c².
double negligible_wall_energy(const Scene& scene);

/// contact_time(), which falls with the velocity, down to its least: π R/c_s.
double contact_time_at_most(double sound_speed, double velocity);

/// The fraction of a kinetic energy that counts as none: numerics.error/100.
double negligible_fraction(const Scene& scene);

/// The fraction of its kinetic energy that the contact may still hold when a body has left for
/// good: numerics.error/4000.
double remaining_fraction(const Scene& scene);

/// Whether the scene is one of motion at an elastic wall whose velocities are reset at intervals.
bool has_resets(const Scene& scene);

/// The height (R), not below `height`, from which the disk comes down in a whole number of
/// intervals between resets; where there are none, `height`.
double on_whole_resets(const Scene& scene, double height);

/// Height of the lowest point at the start of a collision (R): as given or, for `auto`, half an R/c
/// of flight before the height where the energy of the wall is negligible, and where velocities are
/// reset a whole number of resets before height 0, so that what the disk meets there does not
/// depend on where it starts.
double gap_at_start(const Scene& scene, double negligible_height);

/// Rough time at which the question of a scene of motion is answered, R/c. `gap`: of a collision,
/// see gap_at_start(), `gap_in_row`: from disk to disk of a row (R).
double expected_time(const Scene& scene, Eigen::Index points, double gap, double gap_in_row);

}  // namespace impact
