#pragma once

#include "lattice/lattice.hpp"
#include "mechanics/kernels.hpp"

namespace impact {

/// v += factor · F.
inline void kick(double factor, const PointArray& force, PointArray& velocity) {
  kernels().kick(factor, force.data(), velocity.data(), velocity.size());
}

/// v += factor · F, then x += h v.
inline void kick_and_drift(double factor, const PointArray& force, double h, PointArray& velocity,
                           PointArray& position) {
  kernels().kick_and_drift(factor, force.data(), h, velocity.data(), position.data(),
                           position.size());
}

}  // namespace impact
