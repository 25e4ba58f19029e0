#pragma once

#include "lattice/lattice.hpp"

namespace impact {

/// Whether the lattice can change its shape without a change of a bond's length, to first order: a
/// mechanism, as with fewer than 2N − 3 bonds. Then the stiffness matrix of equal bonds,
/// Σ n nᵀ over the bonds' directions n, held against rigid motion at two points, has a pivot of
/// its LDLᵀ factors below 10⁻¹² of the largest.
bool is_floppy(const Lattice& lattice);

}  // namespace impact
