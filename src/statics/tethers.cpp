#include "statics/tethers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace impact {
namespace {

constexpr std::size_t kMostRoots = 64;

/// The bonds of each point.
struct Neighbours {
  struct End {
    Eigen::Index point;
    double length;
  };
  std::vector<std::vector<End>> ends;

  explicit Neighbours(const Lattice& lattice)
      : ends(static_cast<std::size_t>(lattice.points.rows())) {
    for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
      const Bond& bond = lattice.bonds[k];
      const double length = lattice.natural_lengths[k];
      ends[static_cast<std::size_t>(bond.first)].push_back({bond.second, length});
      ends[static_cast<std::size_t>(bond.second)].push_back({bond.first, length});
    }
  }
  std::size_t points() const { return ends.size(); }
};

/// The shortest ways along the bonds from one point to all others (E. W. Dijkstra, 1959).
struct ShortestWays {
  std::vector<double> length;
  std::vector<int> bonds;              ///< of each way
  std::vector<std::size_t> before;     ///< the point before each
  std::vector<std::size_t> by_length;  ///< all points, the root first

  ShortestWays(const Neighbours& neighbours, std::size_t root);
};

ShortestWays::ShortestWays(const Neighbours& neighbours, std::size_t root)
    : length(neighbours.points(), std::numeric_limits<double>::infinity()),
      bonds(neighbours.points(), 0),
      before(neighbours.points(), root) {
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  length[root] = 0.0;
  queue.emplace(0.0, root);
  while (!queue.empty()) {
    const auto [way, point] = queue.top();
    queue.pop();
    if (way > length[point]) continue;
    by_length.push_back(point);
    for (const Neighbours::End& end : neighbours.ends[point]) {
      const auto next = static_cast<std::size_t>(end.point);
      if (way + end.length >= length[next]) continue;
      length[next] = way + end.length;
      bonds[next] = bonds[point] + 1;
      before[next] = point;
      queue.emplace(length[next], next);
    }
  }
}

/// √(Σ w_b²), w_b the fraction of the points beyond the bond b.
double spread_of(const ShortestWays& ways) {
  const auto points = static_cast<double>(ways.length.size());
  std::vector<double> share(ways.length.size(), 1.0 / points);
  double squares = 0.0;
  for (auto point = ways.by_length.rbegin(); point + 1 != ways.by_length.rend(); ++point) {
    squares += share[*point] * share[*point];
    share[ways.before[*point]] += share[*point];
  }
  return std::sqrt(squares);
}

double cross(const PointArray& points, Eigen::Index a, Eigen::Index b, Eigen::Index c) {
  return (points(b, 0) - points(a, 0)) * (points(c, 1) - points(a, 1)) -
         (points(b, 1) - points(a, 1)) * (points(c, 0) - points(a, 0));
}

/// Goes on from the last corner along one half of the hull (A. M. Andrew, 1979).
template <class Order>
void add_half(const PointArray& points, const Order& order, std::vector<Eigen::Index>& corners) {
  const std::size_t first = corners.size();
  for (const Eigen::Index point : order) {
    while (corners.size() >= first + 2 &&
           cross(points, corners[corners.size() - 2], corners.back(), point) <= 0.0) {
      corners.pop_back();
    }
    corners.push_back(point);
  }
  corners.pop_back();
}

}  // namespace

Tethers::Tethers(const Lattice& lattice) {
  const Neighbours neighbours(lattice);
  const std::vector<Eigen::Index> corners = convex_hull(lattice.points);
  const std::size_t interval = (corners.size() + kMostRoots - 1) / kMostRoots;
  for (std::size_t root = 0; root < corners.size(); root += interval) {
    const ShortestWays ways(neighbours, static_cast<std::size_t>(corners[root]));
    const double length = std::accumulate(ways.length.begin(), ways.length.end(), 0.0) /
                          static_cast<double>(ways.length.size());
    const double stretch = spread_of(ways);
    for (std::size_t k = root; k < std::min(root + interval, corners.size()); ++k) {
      const auto corner = static_cast<std::size_t>(corners[k]);
      tethers_.push_back({length + ways.length[corner],
                          stretch + std::sqrt(static_cast<double>(ways.bonds[corner]))});
    }
  }
}

double Tethers::largest_distance(double elongation) const {
  double largest = 0.0;
  for (const Tether& tether : tethers_) {
    largest = std::max(largest, tether.length + tether.stretch * elongation);
  }
  return largest;
}

std::vector<Eigen::Index> convex_hull(const PointArray& points) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(points.rows()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return std::make_pair(points(a, 0), points(a, 1)) < std::make_pair(points(b, 0), points(b, 1));
  });
  std::vector<Eigen::Index> corners;
  add_half(points, order, corners);
  std::reverse(order.begin(), order.end());
  add_half(points, order, corners);
  return corners;
}

}  // namespace impact
