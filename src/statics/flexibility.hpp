#pragma once

#include <limits>

#include "lattice/lattice.hpp"

namespace impact {

/// How far the points of a free lattice can be displaced by a given energy. For bonds of stiffness
/// k_a = 1 and a lattice of mass 1 M; a displacement is measured from the lattice that was moved
/// rigidly to where it fits best.
struct Flexibility {
  /// Largest compliance C of a point, to first order in the strain: with the energy U in its bonds
  /// no point is further from its place than √(2 U C). Infinite: not known, or not stiff.
  double compliance = std::numeric_limits<double>::infinity();
  /// A lower bound of the lowest frequency: with the energy U in the bonds the root mean square
  /// displacement of all points is at most √(2 U)/frequency.
  double lowest_frequency = 0.0;
};

/// Computed for up to 150 points, estimated for more.
Flexibility flexibility(const Lattice& lattice);

/// C is the greatest eigenvalue of the 2 × 2 blocks on the diagonal of K⁺, the inverse of the
/// stiffness on all displacements that are not rigid. The lowest frequency is at least that of the
/// stiffness 1/trace(K⁺). Two sparse solutions a point (LDLᵀ of K with three coordinates tied,
/// which carry nothing since the loads balance).
Flexibility computed_flexibility(const Lattice& lattice);

/// For Delaunay triangulations of more than 100 points. C is a local part, the compliance of a
/// point between neighbours that are held, and a far field that grows with ln N, as that of a
/// force at a point of a sheet does, and with the cube of length over height of a slender body:
///   C = 1.5 + 0.4 ln N + 3 max C_local + (A³ − 1)/2.
/// The lowest frequency of a disk tends to 2.7 c/R; 2.2 is taken. Infinite and 0 for a lattice of
/// fewer than 2.4 bonds a point, which is no triangulation.
Flexibility estimated_flexibility(const Lattice& lattice);

}  // namespace impact
