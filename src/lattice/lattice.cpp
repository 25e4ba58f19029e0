#include "lattice/lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <utility>

#include "lattice/area.hpp"
#include "lattice/input_error.hpp"

namespace impact {
namespace {

void require_one_piece(Eigen::Index points, const std::vector<Bond>& bonds) {
  boost::disjoint_sets_with_storage<> pieces(static_cast<std::size_t>(points));
  Eigen::Index count = points;
  for (const Bond& bond : bonds) {
    const auto first = static_cast<std::size_t>(bond.first);
    const auto second = static_cast<std::size_t>(bond.second);
    if (pieces.find_set(first) != pieces.find_set(second)) {
      pieces.union_set(first, second);
      --count;
    }
  }
  if (count != 1) {
    throw InputError(fmt::format("the bonds leave the lattice in {} pieces, allowed is 1", count));
  }
}

}  // namespace

void require_area(const PointArray& points) {
  if (points.rows() < 3) {
    throw InputError(fmt::format("a lattice needs at least 3 points, got {}", points.rows()));
  }
  const PointArray centred = points.rowwise() - points.colwise().mean();
  const double xx = centred.col(0).square().sum();
  const double yy = centred.col(1).square().sum();
  const double xy = (centred.col(0) * centred.col(1)).sum();
  const double relative_determinant = (xx * yy - xy * xy) / ((xx + yy) * (xx + yy));
  constexpr double kRounding = 1e-14;
  if (!(relative_determinant > kRounding)) {
    throw InputError("the points of the lattice lie on one line (or are not finite numbers)");
  }
}

Lattice make_lattice(PointArray points, std::vector<Bond> bonds) {
  require_area(points);
  std::sort(bonds.begin(), bonds.end());
  const auto twice = std::adjacent_find(bonds.begin(), bonds.end());
  if (twice != bonds.end()) {
    throw InputError(
        fmt::format("points {} and {} are bonded twice", twice->first + 1, twice->second + 1));
  }
  require_one_piece(points.rows(), bonds);

  Lattice lattice{std::move(points), std::move(bonds), {}};
  lattice.natural_lengths.reserve(lattice.bonds.size());
  for (const Bond& bond : lattice.bonds) {
    const double length =
        (lattice.points.row(bond.first) - lattice.points.row(bond.second)).matrix().norm();
    if (!(length > 0.0)) {
      throw InputError(fmt::format("points {} and {} coincide", bond.first + 1, bond.second + 1));
    }
    lattice.natural_lengths.push_back(length);
  }
  return lattice;
}

Lattice joined(const Lattice& first, const Lattice& second) {
  const auto offset = static_cast<std::int32_t>(first.points.rows());
  Lattice both{PointArray(offset + second.points.rows(), 2), first.bonds, first.natural_lengths};
  both.points << first.points, second.points;
  for (const Bond& bond : second.bonds) {
    both.bonds.push_back({bond.first + offset, bond.second + offset});
  }
  both.natural_lengths.insert(both.natural_lengths.end(), second.natural_lengths.begin(),
                              second.natural_lengths.end());
  return both;
}

}  // namespace impact
