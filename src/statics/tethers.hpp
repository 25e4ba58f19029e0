#pragma once

#include <vector>

#include "lattice/lattice.hpp"

namespace impact {

/// How far the points of a lattice can be from its centre of mass however it is folded, for bonds
/// are tethers: the way from a point i to each other point j along the bonds is never longer than
/// |r_i − r_j|. So |r_i − r_cm| ≤ (1/N) Σ_j |r_i − r_j| ≤ Σ_b w_b (l_b + x_b) with w_b the fraction
/// of all points to which the shortest way leads over the bond b of elongation x_b, and by Cauchy
/// and Schwarz the part of the elongations is at most √(Σ w_b²) √(Σ x_b²).
class Tethers {
 public:
  /// Of the outermost points, or 64 of them at even distances, to which the others are tethered.
  explicit Tethers(const Lattice& lattice);

  /// The largest distance (R) of a point from the centre of mass where √(Σ x_b²) is at most
  /// `elongation` (R).
  double largest_distance(double elongation) const;

 private:
  struct Tether {
    double length;   ///< Σ w_b l_b
    double stretch;  ///< √(Σ w_b²)
  };
  std::vector<Tether> tethers_;
};

/// The corners of the convex hull of these points, counter-clockwise.
std::vector<Eigen::Index> convex_hull(const PointArray& points);

}  // namespace impact
