#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lattice/lattice.hpp"

namespace impact {

/// The points that couple to each other, each pair from both ends.
class Couplings {
 public:
  /// Of either triangle of a symmetric matrix whose rows and columns are x of all points and
  /// then y of all: those of x to x.
  Couplings(const Eigen::SparseMatrix<double>& matrix, std::int32_t points);

  std::int32_t points() const { return static_cast<std::int32_t>(first_.size()) - 1; }
  const std::int32_t* begin(std::int32_t point) const { return others_.data() + first(point); }
  const std::int32_t* end(std::int32_t point) const { return others_.data() + first(point + 1); }

 private:
  std::ptrdiff_t first(std::int32_t point) const { return first_[static_cast<std::size_t>(point)]; }
  std::vector<std::ptrdiff_t> first_;
  std::vector<std::int32_t> others_;
};

/// An order of elimination with little fill, and the parts in which to take it.
struct Dissection {
  struct Part {
    std::int32_t first;  ///< of its points in `order`
    std::int32_t end;
    std::vector<std::int32_t> children;  ///< parts before this one
  };
  std::vector<std::int32_t> order;  ///< the point to be eliminated at each place
  std::vector<Part> parts;          ///< in the order of elimination
};

/// Nested dissection (A. George, SIAM J. Numer. Anal. 10, 1973, 345) of a lattice in the plane: the
/// points are halved by a straight line, in the best of four directions; those of one half that
/// couple to the other separate the two, are pushed to and fro until they are few, and are
/// eliminated after both halves, which are treated in the same way. The factor then has a size of
/// O(N log N) and takes O(N^1.5) (R. J. Lipton, D. J. Rose and R. E. Tarjan, ibid. 16, 1979, 346).
Dissection dissect(const PointArray& position, const Couplings& couplings);

}  // namespace impact
