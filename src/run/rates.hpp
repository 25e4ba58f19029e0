#pragma once

#include <optional>

#include "mechanics/contact.hpp"
#include "mechanics/spectrum.hpp"
#include "scene/scene.hpp"

namespace impact {

/// What a resolution is chosen by, besides the scene.
struct Rates {
  Spectrum lattice;
  double wall = 0.0;  ///< square of the frequency that the wall adds at its stiffest, c²/R²
  double sound_speed = 1.0;  ///< c
  /// What a run has met in the place of `wall`: System::stiffest_contact() without its margin.
  std::optional<double> met{};
  double spacing = 1.0;  ///< of the points of the disk, R
  double time = 1.0;     ///< that a run is expected to take, R/c
  bool imex = true;      ///< whether `auto` may take it: not once it began with another method
  bool modal = true;     ///< the same, and not on a floppy lattice
};

/// Estimate of the largest wall force on one point (M c²/R) during the run, for the choice of the
/// step. Total force: twice the load, or that of an impact on a spring and the wall, one on the
/// other; the spring makes a harmonic impact of duration τ = π (R/c_s) √ln(4c_s/v). Its share on
/// one point: twice the greatest pressure p times the point spacing √(π/N) R, and at most the
/// whole; but no less than the force a m v²/2 that stops a single point. 1/p² = 1/p₀² + 1/p₁², of
/// the 2D Hertz contact p₀ = 2P/(π a_c) with a_c² = 4PR/(πE) (K. L. Johnson, Contact Mechanics,
/// 1985, eqs. 4.43–4.45), and of a rigid disk on the wall, which presses like exp(−a x²/2R), p₁ = P
/// √(a/2πR). Some 100 impacts with a v from 0.015 to 200 had 0.4 to 2.9 times the estimate, 1.2
/// times where a spacing is no more than 350/a.
double largest_point_force(const Scene& scene, int points, double sound_speed);

/// The rates of a scene with this law of the contact.
Rates rates(const Scene& scene, const Spectrum& lattice, const Repulsion& law, int points,
            double sound_speed);

/// What the wall is likely to add to the square of a frequency, as Simulation forecasts it for
/// steps of this length by this method. The points that meet the greatest forces are the slowest
/// then: the forecast grows with a v h as its greatest value in some 250 impacts did (N = 300 and
/// 1099, 0.01 … 0.15 c, a v h up to 1.7).
double contact_rate(const Scene& scene, const Rates& rates, IntegratorKind integrator, double step);

/// What bonds that are strained may gain over their unstrained stiffness, as the square of a
/// frequency, where strains are some v: by their cubic part.
double rate_of_gain(const Scene& scene, const Rates& rates);

/// Of a disk with this spacing of the points (R), not rounded.
double points_at(double spacing);

}  // namespace impact
