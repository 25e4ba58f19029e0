#pragma once

#include "lattice/lattice.hpp"
#include "run/bodies.hpp"
#include "scene/scene.hpp"

namespace impact {

/// Where the points of the scene's disk are while it spins steadily at impact.spin: the equilibrium
/// of its bonds and the centrifugal force, in the frame that turns with it. A disk that was set
/// spinning as it lies would breathe instead, and meet the wall in a phase that depends on the gap.
/// @throw InputError when there is no such equilibrium.
PointArray spinning_shape(const Scene& scene, const Bodies& bodies);

}  // namespace impact
