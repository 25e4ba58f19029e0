#pragma once

#include "lattice/lattice.hpp"
#include "run/compose.hpp"
#include "scene/scene.hpp"

namespace impact {

/// Whether a disk that may roll also comes to rest in another orientation than at `rest`: looks for
/// equilibria from eight orientations at equal angles. An equilibrium counts if the disk comes back
/// to it when turned by 0.02 rad, since Newton's method may also end on the ridge between two
/// valleys of the energy. Narrow valleys between two starts may stay unseen.
bool rests_elsewhere(const Scene& scene, const Composition& composition, const PointArray& rest);

}  // namespace impact
