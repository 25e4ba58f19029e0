#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>

#include "lattice/lattice.hpp"

namespace impact {

/// The most bodies that a scene has.
constexpr std::size_t kMostBodies = 4;

/// By which people and files know the body of this number: disk, wall, wall2, wall3.
inline std::string name_of_body(std::size_t number) {
  if (number == 0) return "disk";
  return number == 1 ? "wall" : "wall" + std::to_string(number);
}

/// Where a body is in arrays of all points, and whether it is one.
struct Body {
  Eigen::Index first = 0;  ///< of its rows
  Eigen::Index points = 0;
  /// Whether nothing holds it, so that it has a motion of its own: a disk, not a wall.
  bool is_free = true;

  /// Its rows of such an array.
  auto rows_of(const PointArray& all) const { return all.middleRows(first, points); }
  auto rows_of(PointArray& all) const { return all.middleRows(first, points); }
};

/// Of a body of 1 M and another of this mass, in M.
inline double reduced_mass(double mass) { return mass / (1.0 + mass); }

}  // namespace impact
