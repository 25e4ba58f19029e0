#pragma once

#include "lattice/lattice.hpp"

namespace impact {

/// Turned so that the point farthest from the centre of mass is straight below it, and so the
/// lowest.
Lattice balanced(Lattice lattice);

}  // namespace impact
