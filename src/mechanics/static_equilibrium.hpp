#pragma once

#include "mechanics/force_field.hpp"

namespace impact {

/// How a search for equilibrium ended.
struct EquilibriumSearch {
  bool found = false;
  int iterations = 0;
  double largest_force = 0.0;  ///< largest component of the net force on any point, M c²/R
};

/// Moves `position` to a minimum of the potential energy of the bonds, the wall and the load, with
/// the rigid rotation held if the field holds it: the same state to which damped motion relaxes.
///
/// Newton's method: each step solves K u = f for the displacements u, with K the tangent stiffness
/// of bonds and wall (sparse LDLᵀ). Along an axis on which nothing acts from outside and no support
/// holds, rigid shifts cost no energy and the mean displacement is held at zero; the rotation
/// (RotationHold) is held by a Lagrange multiplier, supported coordinates by leaving them out. A
/// backtracking line search on the energy keeps the search on its way down, and no point moves by
/// more than a few ranges 1/a of the wall in one step. Where K is not positive in the directions
/// that are free, a multiple of the unit matrix is added.
///
/// Found when no component of the net force exceeds `tolerance` (M c²/R).
EquilibriumSearch find_equilibrium(ForceField& field, PointArray& position, double tolerance);

/// The displacements of one step of Newton's method from this position, which is close to an
/// equilibrium: how far it still is from it.
PointArray equilibrium_correction(ForceField field, PointArray position);

}  // namespace impact
