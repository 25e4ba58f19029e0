#pragma once

#include <vector>

#include "mechanics/force_field.hpp"
#include "mechanics/model_error.hpp"
#include "reduced/quasi_static_contact.hpp"

namespace impact {

/// What is known of a slow impact that was run to its end.
struct SlowImpact {
  const QuasiStaticContact& contact;
  const ForceField& field;
  const std::vector<Pose>& poses;     ///< at all steps
  const std::vector<double>& spins;   ///< ω half a step before each, c/R
  const std::vector<double>& forces;  ///< of the wall at each, M c²/R
  double step;                        ///< R/c
  double inertia;                     ///< I, M R²
  double speed_before;                ///< v along y, c
  double speed_after;                 ///< v′ along y, c
};

/// What a ReducedMotion leaves out, from first order perturbation theory and with a margin; M = 1.
///
/// The lever arm x = −∂U/∂φ/F at which the wall pushes with a given force is off by Δx, for three
/// reasons, of which the sizes are added:
/// - The bulk is linear. With the energy ΔE that the bonds hold beyond the linear one, E(u) −
///   ½ uᵀKu at the displacements u of the model, U(Y, φ) changes by ΔE(Y, φ) and
///     Δx = (x ∂ΔE/∂Y − ∂ΔE/∂φ)/F.
/// - The displacements have no inertia. With their kinetic energy ½ m |∂u/∂Y V + ∂u/∂φ ω|², where
///   V and ω are small, dV/dt = F and dω/dt = x F/I,
///     Δx = m (∂u/∂Y + ∂u/∂φ x/I)·(x ∂u/∂Y − ∂u/∂φ).
/// - They change the moment of inertia by δI = 2 m s·u, s being the points about the centre of
/// mass.
///   With the kinetic energy ½ δI ω²,
///     Δx = m ω² s·(x ∂u/∂Y − ∂u/∂φ)/F.
/// Taken where F is greatest and where it is half of that, whichever gives most. The momentum
/// (1 + e) v of the wall then gives the error of the spin, and the energy, of which nothing else is
/// lost, that of the restitution:
///   Δω = (1 + e) v |Δx|/I,  Δe/e = I Δω (|ω| + Δω/2)/(e v)².
///
/// Nothing vibrates. The force of the model would leave the energy E_v in vibrations, see
/// energy_of_vibrations(), to which that of the bonds at the start is added: points that start
/// within reach of the wall are not in balance there. Δe/e = E_v/(e v)².
///
/// Forces and times err by what the elastic displacement would change of the energy, ΔE and its
/// kinetic energy, over the energy of the impact, and by the amplitude of vibrations,
/// √(E_v/(v²/2)).
///
/// Margins: 5 for e and the spin, 15 with fewer than 100 points, of which few carry the contact; 10
/// for forces and times (doc/report.md has the errors against the full model).
ModelError left_out(const SlowImpact& impact);

}  // namespace impact
