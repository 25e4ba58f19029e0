#include <algorithm>
#include <utility>

#include "lattice/area.hpp"
#include "lattice/lattice.hpp"
#include "lattice/ordering.hpp"
#include "lattice/triangulation.hpp"

namespace impact {

Lattice triangulated_lattice(const PointArray& points) {
  require_area(points);
  // Along a curve first: where the points lie in memory at random, the next steps take twice as
  // long at N = 10⁶.
  const PointArray along_curve = points(hilbert_order(points), Eigen::all);
  std::vector<Bond> bonds = delaunay_bonds_in_order(along_curve);
  const std::vector<std::int32_t> order =
      grouped_by_bonds(storage_order(points.rows(), bonds), bonds);

  std::vector<std::int32_t> new_index(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    new_index[static_cast<std::size_t>(order[i])] = static_cast<std::int32_t>(i);
  }
  for (Bond& bond : bonds) {
    const std::int32_t first = new_index[static_cast<std::size_t>(bond.first)];
    const std::int32_t second = new_index[static_cast<std::size_t>(bond.second)];
    bond = {std::min(first, second), std::max(first, second)};
  }
  return make_lattice(along_curve(order, Eigen::all), std::move(bonds));
}

}  // namespace impact
