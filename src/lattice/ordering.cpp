#include "lattice/ordering.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/cuthill_mckee_ordering.hpp>
#include <boost/graph/properties.hpp>

namespace impact {

std::vector<std::int32_t> storage_order(Eigen::Index points, const std::vector<Bond>& bonds) {
  using Properties = boost::property<boost::vertex_color_t, boost::default_color_type>;
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Properties>;
  Graph graph(static_cast<std::size_t>(points));
  for (const Bond& bond : bonds) {
    boost::add_edge(static_cast<std::size_t>(bond.first), static_cast<std::size_t>(bond.second),
                    graph);
  }
  std::vector<std::int32_t> order(static_cast<std::size_t>(points));
  boost::cuthill_mckee_ordering(graph, order.rbegin(), boost::get(boost::vertex_color, graph),
                                boost::make_degree_map(graph));
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
