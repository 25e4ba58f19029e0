#pragma once

#include "lattice/lattice.hpp"
#include "mechanics/bond_forces.hpp"

namespace impact {

/// A disk at rest on the potential wall under a load, its rotation held.
struct PressedDisk {
  const Lattice& lattice;
  BondLaw law;
  double wall_a = 0.0;  ///< 1/R
  double load = 0.0;    ///< M c²/R
};

struct PreciseStrain {
  double value;  ///< ξ, R
  double error;  ///< relative: what the last step of Newton's method changed
};

/// The compression of a state close to rest, improved by Newton's method where rounding does not
/// limit it: in displacements from the reference, not positions, and in long double. A bond's
/// elongation is x = (2 d·δ + δ·δ)/(|d + δ| + |d|) with its reference vector d and the difference δ
/// of displacements. The wall's V₀ does not enter: it only sets the height of the whole disk.
/// @throw std::runtime_error when the iteration does not converge.
PreciseStrain precise_strain(const PressedDisk& disk, const PointArray& near_rest);

}  // namespace impact
