#pragma once

#include "lattice/lattice.hpp"
#include "mechanics/kernels.hpp"

namespace impact {

/// y += factor · x.
inline void add_scaled(double factor, const PointArray& x, PointArray& y) {
  kernels().add_scaled(factor, x.data(), y.data(), y.size());
}

}  // namespace impact
