#include "lattice/ordering.hpp"

#include <algorithm>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/cuthill_mckee_ordering.hpp>
#include <boost/graph/properties.hpp>
#include <utility>

namespace impact {

std::vector<std::int32_t> storage_order(Eigen::Index points, const std::vector<Bond>& bonds) {
  using Nothing = boost::no_property;
  using Graph = boost::compressed_sparse_row_graph<boost::directedS, Nothing, Nothing, Nothing,
                                                   std::uint32_t, std::uint32_t>;
  const auto size = static_cast<std::size_t>(points);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> from_both_ends;
  from_both_ends.reserve(2 * bonds.size());
  for (const Bond& bond : bonds) {
    from_both_ends.emplace_back(bond.first, bond.second);
    from_both_ends.emplace_back(bond.second, bond.first);
  }
  const Graph graph(boost::edges_are_unsorted_multi_pass, from_both_ends.begin(),
                    from_both_ends.end(), static_cast<std::uint32_t>(size));
  std::vector<boost::default_color_type> colour(size);
  std::vector<std::int32_t> order(size);
  boost::cuthill_mckee_ordering(
      graph, order.rbegin(),
      boost::make_iterator_property_map(colour.begin(), boost::get(boost::vertex_index, graph)),
      boost::make_out_degree_map(graph));
  return order;
}

std::vector<std::int32_t> grouped_by_bonds(std::vector<std::int32_t> order,
                                           const std::vector<Bond>& bonds) {
  constexpr std::ptrdiff_t kGroup = 256;
  std::vector<int> bonds_of(order.size(), 0);
  for (const Bond& bond : bonds) {
    ++bonds_of[static_cast<std::size_t>(bond.first)];
    ++bonds_of[static_cast<std::size_t>(bond.second)];
  }
  for (auto begin = order.begin(); begin != order.end();) {
    const auto end = begin + std::min(kGroup, order.end() - begin);
    std::stable_sort(begin, end, [&](std::int32_t a, std::int32_t b) {
      return bonds_of[static_cast<std::size_t>(a)] > bonds_of[static_cast<std::size_t>(b)];
    });
    begin = end;
  }
  return order;
}

}  // namespace impact
