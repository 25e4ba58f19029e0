#pragma once

#include <Eigen/SparseCore>

#include "lattice/lattice.hpp"

namespace impact {

/// The stiffness matrix of a free lattice with k_a = 1, rows and columns x of all points, then y.
/// A point is held, and the one furthest from it is kept from turning about it: for loads that
/// balance these ties carry nothing, and only pick one of the equivalent rigid motions.
Eigen::SparseMatrix<double> tied_stiffness(const Lattice& lattice);

}  // namespace impact
