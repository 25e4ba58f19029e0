#pragma once

#include "mechanics/spectrum.hpp"
#include "mechanics/wall_contact.hpp"
#include "scene/scene.hpp"

namespace impact {

/// Estimate of the largest wall force on one point (M c²/R) during the run, for the choice of the
/// step. Total force: that of a harmonic impact of duration τ = π (R/c_s) √ln(4c_s/v), or twice
/// the load. Its share on one point: twice the greatest pressure of the 2D Hertz contact,
/// p₀ = 2P/(π a_c) with a_c² = 4PR/(πE) (K. L. Johnson, Contact Mechanics, 1985, eqs. 4.43–4.45),
/// times the point spacing √(π/N) R, and at most the whole; but no less than the force a m v²/2
/// that stops a single point.
double largest_point_force(const Scene& scene, int points, double sound_speed);

/// The step of the run (R/c).
///
/// `auto`: half the stability limit 2/ω without damping, at most 0.9 of the limit with damping,
/// the wall at its expected stiffest counted, and at most 0.02 R/c; rounded down to 1, 2 or 5 times
/// a power of ten, so that the usual output periods are its multiples. The factor 1/2 is for
/// accuracy: there the restitution of the default impact is good to better than 10⁻⁴.
///
/// Where velocities are reset at intervals, the step, given or not, is shortened to divide them.
/// @throw InputError when the given step exceeds the stability limit of the lattice and its
/// damping.
double choose_step(const Scene& scene, const Spectrum& spectrum, const WallContact& wall,
                   int points, double sound_speed);

/// The largest of 1, 2, 5 times a power of ten that is not above `value`.
double round_down_to_125(double value);

}  // namespace impact
