#pragma once

#include <cmath>

#include "lattice/lattice.hpp"

namespace impact {

/// A lattice whose natural lengths are its present ones, without the checks of make_lattice().
inline Lattice plain_lattice(PointArray points, std::vector<Bond> bonds) {
  Lattice lattice{std::move(points), std::move(bonds), {}};
  for (const Bond& bond : lattice.bonds) {
    lattice.natural_lengths.push_back(
        (lattice.points.row(bond.first) - lattice.points.row(bond.second)).matrix().norm());
  }
  return lattice;
}

/// Two points at distance 1 on the x axis.
inline Lattice two_points() {
  PointArray points(2, 2);
  points << 0, 0, 1, 0;
  return plain_lattice(points, {{0, 1}});
}

/// An equilateral triangle of side 1.
inline Lattice triangle() {
  PointArray points(3, 2);
  points << 0, 0, 1, 0, 0.5, std::sqrt(0.75);
  return plain_lattice(points, {{0, 1}, {0, 2}, {1, 2}});
}

/// A patch of the triangular lattice with bonds of length 1, its rows along x. The row 0 is the
/// lowest; points are stored row after row.
inline Lattice triangular_patch(int columns, int rows) {
  PointArray points(columns * rows, 2);
  std::vector<Bond> bonds;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int i = row * columns + column;
      points.row(i) << column + 0.5 * (row % 2), row * std::sqrt(0.75);
      if (column + 1 < columns) bonds.push_back({i, i + 1});
      if (row + 1 == rows) continue;
      bonds.push_back({i, i + columns});
      const int other = column + (row % 2 == 0 ? -1 : 1);
      if (other >= 0 && other < columns) bonds.push_back({i, (row + 1) * columns + other});
    }
  }
  return plain_lattice(points, bonds);
}
inline Lattice triangular_patch(int side) { return triangular_patch(side, side); }

}  // namespace impact
