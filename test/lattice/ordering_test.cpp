#include "lattice/ordering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "lattice/placement.hpp"

namespace impact {
namespace {

double mean_index_distance(const std::vector<Bond>& bonds) {
  double sum = 0.0;
  for (const Bond& bond : bonds) sum += bond.second - bond.first;
  return sum / static_cast<double>(bonds.size());
}

TEST(StorageOrder, IsAPermutation) {
  std::vector<std::int32_t> order = storage_order(5, {{0, 3}, {1, 3}, {1, 4}, {2, 4}});
  std::sort(order.begin(), order.end());
  const std::vector<std::int32_t> all{0, 1, 2, 3, 4};
  EXPECT_EQ(order, all);
}

/// A chain stored in any order becomes a chain of neighbours.
TEST(StorageOrder, PutsAChainInItsOrder) {
  const std::vector<Bond> chain{{0, 3}, {1, 3}, {1, 4}, {2, 4}};
  const std::vector<std::int32_t> order = storage_order(5, chain);
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    const Bond step{std::min(order[k], order[k + 1]), std::max(order[k], order[k + 1])};
    EXPECT_TRUE(std::find(chain.begin(), chain.end(), step) != chain.end()) << k;
  }
}

/// In a disk of N points the fronts of the Cuthill–McKee order are about √N long; without an order
/// the ends of a bond lie N/3 apart.
TEST(StorageOrder, KeepsNeighboursClose) {
  const Lattice lattice = triangulated_lattice(place_in_disk({4000}, 1));
  EXPECT_LT(mean_index_distance(lattice.bonds), 2.0 * std::sqrt(4000.0));
}

/// In 300 points: the first 256 by their bonds, and the rest by theirs; points of equally many
/// bonds in the order that was given.
TEST(GroupedByBonds, SortsGroupsOf256) {
  std::vector<std::int32_t> order(300);
  std::iota(order.rbegin(), order.rend(), 0);
  const std::vector<Bond> bonds{{0, 1}, {1, 100}, {100, 200}, {100, 299}};
  const std::vector<std::int32_t> grouped = grouped_by_bonds(order, bonds);
  const std::vector<std::int32_t> first{100, 299, 200, 298};
  EXPECT_TRUE(std::equal(first.begin(), first.end(), grouped.begin()));
  const std::vector<std::int32_t> second{1, 0, 43, 42};
  EXPECT_TRUE(std::equal(second.begin(), second.end(), grouped.begin() + 256));
  EXPECT_TRUE(std::is_permutation(order.begin(), order.end(), grouped.begin()));
}

}  // namespace
}  // namespace impact
