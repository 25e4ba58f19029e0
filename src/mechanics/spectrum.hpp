#pragma once

#include "lattice/lattice.hpp"
#include "mechanics/bond_forces.hpp"

namespace impact {

/// The fastest rates of an unstrained lattice.
struct Spectrum {
  double omega_squared = 0.0;  ///< square of the highest frequency, c²/R²
  double gamma = 0.0;  ///< highest damping rate: η/m times the Laplacian's largest eigenvalue, c/R
};

/// Largest eigenvalues of the stiffness matrix Σ k_a n nᵀ and of the damping Laplacian, each over
/// the point mass, by the Lanczos method (C. Lanczos, J. Res. NBS 45 (1950) 255). A Ritz value
/// approaches the largest eigenvalue from below; the iteration ends when it grows by less than 10⁻⁵
/// in ten steps, and 0.2 % are added, so that the values bound the true ones from above.
Spectrum lattice_spectrum(const Lattice& lattice, const BondLaw& law, double point_mass);

}  // namespace impact
