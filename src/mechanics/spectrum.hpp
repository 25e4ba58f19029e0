#pragma once

#include <cstdint>
#include <vector>

#include "lattice/lattice.hpp"
#include "mechanics/bond_forces.hpp"

namespace impact {

/// The fastest rates of an unstrained lattice.
struct Spectrum {
  /// Of omega_squared: the rate with which `stiffened` is found.
  static constexpr double kStiffening = 0.45;

  double omega_squared = 0.0;  ///< square of the highest frequency, c²/R²
  double gamma = 0.0;  ///< highest damping rate: η/m times the Laplacian's largest eigenvalue, c/R
  /// The square of the highest frequency where all outer points are held by springs of kStiffening
  /// omega_squared over the point mass along the normal of the outline, and of 0.3 of that along
  /// the outline, for contacts that are not quite normal to it; 0: not known.
  double stiffened = 0.0;

  /// Estimate from above, for the unstrained lattice, of the square of the highest frequency where
  /// contacts hold outer points by springs of up to `rate` over the point mass (c²/R²), and all
  /// others by `inner_share` of that. Of the outer ones alone it is a convex function of the rate,
  /// as the largest eigenvalue of K + rate P always is, and its slope at most 1: so it lies below
  /// the line between the two values that are known, and from there on below the line of slope 1.
  double with_contacts(double rate, double inner_share) const;
};

/// Largest eigenvalues of the stiffness matrix Σ k_a n nᵀ and of the damping Laplacian, each over
/// the point mass, by the Lanczos method (C. Lanczos, J. Res. NBS 45 (1950) 255). A Ritz value
/// approaches the largest eigenvalue from below; the iteration ends when it grows by less than 10⁻⁵
/// in five steps, and 0.2 % are added, so that the values bound the true ones from above.
/// `outer`: the points that may come into contact; none: `stiffened` is left out.
Spectrum lattice_spectrum(const Lattice& lattice, const BondLaw& law, double point_mass,
                          const std::vector<std::int32_t>& outer = {});

}  // namespace impact
