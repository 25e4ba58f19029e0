#include "lattice/triangulation.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "lattice/input_error.hpp"

namespace impact {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::int32_t, Kernel>;
using Triangulation =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;
using IndexedPoint = std::pair<Kernel::Point_2, std::int32_t>;
using SortTraits =
    CGAL::Spatial_sort_traits_adapter_2<Kernel, CGAL::First_of_pair_property_map<IndexedPoint>>;

std::vector<IndexedPoint> with_indices(const PointArray& points) {
  std::vector<IndexedPoint> indexed;
  indexed.reserve(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    indexed.emplace_back(Kernel::Point_2(points(i, 0), points(i, 1)), static_cast<std::int32_t>(i));
  }
  return indexed;
}

}  // namespace

std::vector<std::int32_t> hilbert_order(const PointArray& points) {
  std::vector<IndexedPoint> indexed = with_indices(points);
  CGAL::hilbert_sort(indexed.begin(), indexed.end(), SortTraits());
  std::vector<std::int32_t> order;
  order.reserve(indexed.size());
  for (const IndexedPoint& point : indexed) order.push_back(point.second);
  return order;
}

std::vector<Bond> delaunay_bonds(const PointArray& points) {
  const std::vector<std::int32_t> order = hilbert_order(points);
  std::vector<Bond> bonds = delaunay_bonds_in_order(points(order, Eigen::all));
  for (Bond& bond : bonds) {
    const auto [a, b] = std::minmax(order[static_cast<std::size_t>(bond.first)],
                                    order[static_cast<std::size_t>(bond.second)]);
    bond = {a, b};
  }
  std::sort(bonds.begin(), bonds.end());
  return bonds;
}

std::vector<Bond> delaunay_bonds_in_order(const PointArray& points) {
  // CGAL's own range insertion shuffles the points by a generator that lives as long as the
  // program, so a second lattice of the same seed could differ. A Hilbert curve needs no shuffling.
  std::vector<IndexedPoint> indexed = with_indices(points);
  Triangulation triangulation;
  Triangulation::Face_handle hint;
  for (const IndexedPoint& point : indexed) {
    const auto vertex = triangulation.insert(point.first, hint);
    vertex->info() = point.second;
    hint = vertex->face();
  }
  if (triangulation.number_of_vertices() != indexed.size()) {
    std::sort(indexed.begin(), indexed.end());
    const auto same =
        std::adjacent_find(indexed.begin(), indexed.end(),
                           [](const auto& a, const auto& b) { return a.first == b.first; });
    throw InputError(
        fmt::format("two points coincide, at ({}, {})", same->first.x(), same->first.y()));
  }

  std::vector<Bond> bonds;
  bonds.reserve(3 * indexed.size());
  for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end();
       ++edge) {
    const std::int32_t a = edge->first->vertex(Triangulation::cw(edge->second))->info();
    const std::int32_t b = edge->first->vertex(Triangulation::ccw(edge->second))->info();
    bonds.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(bonds.begin(), bonds.end());
  return bonds;
}

}  // namespace impact
