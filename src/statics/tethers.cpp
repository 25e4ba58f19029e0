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

/// The bonds of each point by their numbers, those of point i from begin[i] on. Of the lattice,
/// which must live as long.
class BondsOfPoints {
 public:
  explicit BondsOfPoints(const Lattice& lattice);

  std::size_t points() const { return begin_.size() - 1; }

  /// Calls use(other end, natural length) for each bond of the point.
  template <class Use>
  void for_each(std::size_t point, const Use& use) const {
    for (std::int32_t k = begin_[point]; k < begin_[point + 1]; ++k) {
      const auto number = static_cast<std::size_t>(numbers_[static_cast<std::size_t>(k)]);
      const Bond& bond = lattice_->bonds[number];
      const bool is_first = static_cast<std::size_t>(bond.first) == point;
      use(static_cast<std::size_t>(is_first ? bond.second : bond.first),
          lattice_->natural_lengths[number]);
    }
  }

 private:
  const Lattice* lattice_;
  std::vector<std::int32_t> begin_;
  std::vector<std::int32_t> numbers_;
};

BondsOfPoints::BondsOfPoints(const Lattice& lattice)
    : lattice_(&lattice),
      begin_(static_cast<std::size_t>(lattice.points.rows()) + 1, 0),
      numbers_(2 * lattice.bonds.size()) {
  for (const Bond& bond : lattice.bonds) {
    ++begin_[static_cast<std::size_t>(bond.first)];
    ++begin_[static_cast<std::size_t>(bond.second)];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  for (std::size_t k = lattice.bonds.size(); k-- > 0;) {  // the last first, each list from its end
    for (const std::int32_t end : {lattice.bonds[k].first, lattice.bonds[k].second}) {
      const std::int32_t place = --begin_[static_cast<std::size_t>(end)];
      numbers_[static_cast<std::size_t>(place)] = static_cast<std::int32_t>(k);
    }
  }
}

/// The shortest ways along the bonds from one point to all others (E. W. Dijkstra, 1959).
struct ShortestWays {
  std::vector<double> length;
  std::vector<std::int32_t> bonds;      ///< of each way
  std::vector<std::int32_t> before;     ///< the point before each
  std::vector<std::int32_t> by_length;  ///< all points, the root first

  ShortestWays(const BondsOfPoints& bonds_of_points, std::int32_t root);
};

ShortestWays::ShortestWays(const BondsOfPoints& bonds_of_points, std::int32_t root)
    : length(bonds_of_points.points(), std::numeric_limits<double>::infinity()),
      bonds(bonds_of_points.points(), 0),
      before(bonds_of_points.points(), root) {
  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  by_length.reserve(bonds_of_points.points());
  length[static_cast<std::size_t>(root)] = 0.0;
  queue.emplace(0.0, root);
  while (!queue.empty()) {
    const Entry nearest = queue.top();
    queue.pop();
    const auto point = static_cast<std::size_t>(nearest.second);
    if (nearest.first > length[point]) continue;
    by_length.push_back(nearest.second);
    bonds_of_points.for_each(point, [&](std::size_t next, double bond) {
      if (length[point] + bond >= length[next]) return;
      length[next] = length[point] + bond;
      bonds[next] = bonds[point] + 1;
      before[next] = nearest.second;
      queue.emplace(length[next], static_cast<std::int32_t>(next));
    });
  }
}

/// √(Σ w_b²), w_b the fraction of the points beyond the bond b.
double spread_of(const ShortestWays& ways) {
  const auto points = static_cast<double>(ways.length.size());
  std::vector<double> share(ways.length.size(), 1.0 / points);
  double squares = 0.0;
  for (auto number = ways.by_length.rbegin(); number + 1 != ways.by_length.rend(); ++number) {
    const auto point = static_cast<std::size_t>(*number);
    squares += share[point] * share[point];
    share[static_cast<std::size_t>(ways.before[point])] += share[point];
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
  const std::vector<Eigen::Index> corners = convex_hull(lattice.points);
  const BondsOfPoints bonds_of_points(lattice);
  const std::size_t interval = (corners.size() + kMostRoots - 1) / kMostRoots;
  for (std::size_t root = 0; root < corners.size(); root += interval) {
    const ShortestWays ways(bonds_of_points, static_cast<std::int32_t>(corners[root]));
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
