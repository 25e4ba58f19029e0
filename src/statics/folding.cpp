#include "statics/folding.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace impact {
namespace {

/// Twice the area, positive where a, b, c run counter-clockwise.
double signed_area(const Eigen::Ref<const PointArray>& points, std::int32_t a, std::int32_t b,
                   std::int32_t c) {
  return (points(b, 0) - points(a, 0)) * (points(c, 1) - points(a, 1)) -
         (points(b, 1) - points(a, 1)) * (points(c, 0) - points(a, 0));
}

/// A bond as seen from one of its ends.
struct Spoke {
  double angle;
  std::int32_t to;
};

/// The bonds of every point, counter-clockwise: those of point i are spokes[begin[i]] …
/// spokes[begin[i + 1]].
struct Wheels {
  std::vector<std::size_t> begin;
  std::vector<Spoke> spokes;
};

Wheels wheels(const Lattice& lattice) {
  const auto points = static_cast<std::size_t>(lattice.points.rows());
  Wheels all{std::vector<std::size_t>(points + 1, 0), std::vector<Spoke>(2 * lattice.bonds.size())};
  for (const Bond& bond : lattice.bonds) {
    ++all.begin[static_cast<std::size_t>(bond.first)];
    ++all.begin[static_cast<std::size_t>(bond.second)];
  }
  std::partial_sum(all.begin.begin(), all.begin.end(), all.begin.begin());
  const auto add = [&](std::int32_t from, std::int32_t to) {
    const auto way = (lattice.points.row(to) - lattice.points.row(from)).eval();
    all.spokes[--all.begin[static_cast<std::size_t>(from)]] = {std::atan2(way(1), way(0)), to};
  };
  for (const Bond& bond : lattice.bonds) {
    add(bond.first, bond.second);
    add(bond.second, bond.first);
  }
  const auto place = [&](std::size_t k) {
    return all.spokes.begin() + static_cast<std::ptrdiff_t>(all.begin[k]);
  };
  for (std::size_t i = 0; i < points; ++i) {
    std::sort(place(i), place(i + 1),
              [](const Spoke& a, const Spoke& b) { return a.angle < b.angle; });
  }
  return all;
}

}  // namespace

Triangles::Triangles(const Lattice& lattice) {
  const auto [begin, spokes] = wheels(lattice);
  corners_.reserve(lattice.bonds.size());
  for (std::size_t i = 0; i + 1 < begin.size(); ++i) {
    const auto a = static_cast<std::int32_t>(i);
    for (std::size_t k = begin[i]; k < begin[i + 1]; ++k) {
      const std::int32_t b = spokes[k].to;
      const std::int32_t c = spokes[k + 1 < begin[i + 1] ? k + 1 : begin[i]].to;
      if (a > b || a > c) continue;  // each triangle from its first corner
      const bool bonded = std::binary_search(lattice.bonds.begin(), lattice.bonds.end(),
                                             Bond{std::min(b, c), std::max(b, c)});
      if (bonded && signed_area(lattice.points, a, b, c) > 0.0) corners_.push_back({a, b, c});
    }
  }
  corners_.shrink_to_fit();
}

std::size_t Triangles::turned_over(const Eigen::Ref<const PointArray>& position) const {
  return static_cast<std::size_t>(
      std::count_if(corners_.begin(), corners_.end(), [&](const auto& triangle) {
        return signed_area(position, triangle[0], triangle[1], triangle[2]) < 0.0;
      }));
}

double Triangles::least_area_left(const Eigen::Ref<const PointArray>& reference,
                                  const Eigen::Ref<const PointArray>& position) const {
  double least = 1.0;
  for (const auto& [a, b, c] : corners_) {
    least = std::min(least, signed_area(position, a, b, c) / signed_area(reference, a, b, c));
  }
  return least;
}

std::vector<std::int32_t> Triangles::outer_points(const Lattice& lattice, double depth) const {
  std::vector<int> open(static_cast<std::size_t>(lattice.points.rows()), 0);
  for (const Bond& bond : lattice.bonds) {
    ++open[static_cast<std::size_t>(bond.first)];
    ++open[static_cast<std::size_t>(bond.second)];
  }
  for (const auto& triangle : corners_) {
    for (const std::int32_t corner : triangle) --open[static_cast<std::size_t>(corner)];
  }
  std::vector<char> is_outer(open.begin(), open.end());
  for (auto [a, b, c] : corners_) {
    for (int k = 0; k < 3; ++k) {
      std::tie(a, b, c) = std::make_tuple(b, c, a);
      if (open[static_cast<std::size_t>(a)] == 0 || open[static_cast<std::size_t>(b)] == 0)
        continue;
      const double side = (lattice.points.row(b) - lattice.points.row(a)).matrix().norm();
      if (signed_area(lattice.points, a, b, c) < depth * side) {
        is_outer[static_cast<std::size_t>(c)] = 1;
      }
    }
  }
  std::vector<std::int32_t> points;
  for (std::size_t i = 0; i < is_outer.size(); ++i) {
    if (is_outer[i] != 0) points.push_back(static_cast<std::int32_t>(i));
  }
  return points;
}

}  // namespace impact
