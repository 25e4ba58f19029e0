#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lattice/lattice.hpp"

namespace impact {

/// The triangles of a lattice, by which one sees whether it has folded: where a point is pressed
/// through the bond opposite to it, the triangle turns over. Springs do not resist that any more
/// than the other way round, so a lattice that is pressed too hard snaps into folds and may stay in
/// them.
class Triangles {
 public:
  /// Every three points that are bonded to each other, with nothing between their bonds.
  explicit Triangles(const Lattice& lattice);

  /// How many are turned over.
  std::size_t turned_over(const Eigen::Ref<const PointArray>& position) const;

  /// The least part of its area in `reference` that a triangle has; negative: it is turned over.
  double least_area_left(const Eigen::Ref<const PointArray>& reference,
                         const Eigen::Ref<const PointArray>& position) const;

  std::size_t size() const { return corners_.size(); }

  /// Of the lattice whose triangles these are, the points that come into contact first: those with
  /// fewer triangles about them than bonds, which lie on its outline or about a hole, and any that
  /// lies nearer to two of these, bonded to it and to each other, than `depth` (R).
  std::vector<std::int32_t> outer_points(const Lattice& lattice, double depth) const;

 private:
  std::vector<std::array<std::int32_t, 3>> corners_;  ///< counter-clockwise in the reference
};

}  // namespace impact
