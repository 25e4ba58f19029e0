#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace impact {

/// Positions, velocities or forces: one row a point, columns x and y.
using PointArray = Eigen::Array<double, Eigen::Dynamic, 2>;

/// Such an array, of whatever owner and layout, to read and to write.
using AnyStride = Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>;
using ConstPoints = Eigen::Ref<const PointArray, 0, AnyStride>;
using Points = Eigen::Ref<PointArray, 0, AnyStride>;

/// A spring between two points, by their 0-based indices; `first < second`.
struct Bond {
  std::int32_t first;
  std::int32_t second;
};

inline bool operator==(const Bond& a, const Bond& b) {
  return a.first == b.first && a.second == b.second;
}
inline bool operator<(const Bond& a, const Bond& b) {
  return a.first != b.first ? a.first < b.first : a.second < b.second;
}

/// A network of points and bonds in its stress-free reference configuration. Lengths in R.
struct Lattice {
  PointArray points;
  std::vector<Bond> bonds;              ///< sorted, each pair once
  std::vector<double> natural_lengths;  ///< of each bond: its length in the reference configuration
};

/// The lattice of these points and bonds; every bond's natural length is its present length.
/// The bonds are sorted.
/// @throw InputError when there are fewer than three points, all lie on one line, a bond has no
/// length, a pair is bonded twice, or the bonds leave the lattice in more than one piece.
Lattice make_lattice(PointArray points, std::vector<Bond> bonds);

/// Joins the points along the edges of their Delaunay triangulation and stores them in an order
/// that keeps neighbours close in memory (see ordering.hpp).
/// @throw InputError as make_lattice(points, bonds), and when two points coincide.
Lattice triangulated_lattice(const PointArray& points);

/// Two lattices in one set of arrays, without a bond between them: the points of `first`, then
/// those of `second`.
Lattice joined(const Lattice& first, const Lattice& second);

}  // namespace impact
