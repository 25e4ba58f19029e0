#pragma once

#include <vector>

#include "reduced/quasi_static_contact.hpp"

namespace impact {

/// A vibration that a load of a given shape excites.
struct ExcitedMode {
  double frequency;  ///< c/R
  double weight;     ///< square of the modal load over that of a total force of 1, 1/M
};

/// What the load of the contact would excite if it came suddenly: Ritz values of m P K⁺ P/k_a, the
/// eigenvalues of which are 1/ω², by twelve steps of Lanczos's method begun with the load (E. L.
/// Wilson, M.-W. Yuan and J. M. Dickens, Earthq. Eng. Struct. Dyn. 10 (1982) 813). The slowest are
/// modes of the body; the others stand for many. `point_mass` in M.
std::vector<ExcitedMode> excited_modes(const QuasiStaticContact& contact, double point_mass);

/// Energy (M c²) that a load of this shape leaves in these modes when its total (M c²/R) takes the
/// given values, `step` R/c apart, and is zero before and after:
///   Σ w |∫ F exp(iωt) dt|²/2.
/// Where ω times the step exceeds 1.5, which is far beyond what the force contains, it is left out.
double energy_of_vibrations(const std::vector<ExcitedMode>& modes,
                            const std::vector<double>& forces, double step);

}  // namespace impact
