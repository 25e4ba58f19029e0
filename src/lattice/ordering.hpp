#pragma once

#include <cstdint>
#include <vector>

#include "lattice/lattice.hpp"

namespace impact {

/// The order in which to store the points of a bond network so that neighbours lie close in
/// memory: reverse Cuthill–McKee (E. Cuthill and J. McKee, Proc. 24th ACM Nat. Conf., 1969, 157).
/// Element k is the index of the point to store at place k. test/bench/bench_lattice.cpp measures
/// it against a Hilbert curve and a random order.
std::vector<std::int32_t> storage_order(Eigen::Index points, const std::vector<Bond>& bonds);

/// The same order, but of each 256 points in a row those with more bonds first. The force kernels
/// treat points in slices of eight, in the time of the one with the most bonds.
std::vector<std::int32_t> grouped_by_bonds(std::vector<std::int32_t> order,
                                           const std::vector<Bond>& bonds);

}  // namespace impact
