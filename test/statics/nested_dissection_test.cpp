#include "statics/nested_dissection.hpp"

#include <gtest/gtest.h>

#include <Eigen/SparseCore>
#include <algorithm>
#include <random>
#include <set>

#include "mechanics/bond_forces.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

Couplings couplings_of(const Lattice& lattice) {
  const auto entries = BondForces(lattice, {1.0, 0.0, 0.0}).stiffness(lattice.points);
  Eigen::SparseMatrix<double> stiffness(2 * lattice.points.rows(), 2 * lattice.points.rows());
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return {stiffness.triangularView<Eigen::Lower>(),
          static_cast<std::int32_t>(lattice.points.rows())};
}

TEST(Couplings, AreTheBondsFromBothEnds) {
  const Lattice patch = triangular_patch(4, 3);
  const Couplings couplings = couplings_of(patch);
  std::set<std::pair<std::int32_t, std::int32_t>> expected;
  for (const Bond& bond : patch.bonds) {
    expected.insert({{bond.first, bond.second}, {bond.second, bond.first}});
  }
  std::set<std::pair<std::int32_t, std::int32_t>> found;
  for (std::int32_t i = 0; i < couplings.points(); ++i) {
    std::for_each(couplings.begin(i), couplings.end(i), [&](std::int32_t other) {
      EXPECT_TRUE(found.insert({i, other}).second);
    });
  }
  EXPECT_EQ(found, expected);
}

/// The number of the part of each point.
std::vector<std::int32_t> parts_of(const Dissection& dissection) {
  std::vector<std::int32_t> part(dissection.order.size(), -1);
  for (std::size_t k = 0; k < dissection.parts.size(); ++k) {
    for (std::int32_t place = dissection.parts[k].first; place < dissection.parts[k].end; ++place) {
      part[static_cast<std::size_t>(dissection.order[static_cast<std::size_t>(place)])] =
          static_cast<std::int32_t>(k);
    }
  }
  return part;
}

/// Every point has a place in one part, and bonds lead only to parts above or below in the tree:
/// two parts beside each other can be eliminated in either order.
void expect_separated(const Lattice& lattice, const Dissection& dissection) {
  std::vector<std::int32_t> points = dissection.order;
  std::sort(points.begin(), points.end());
  for (std::size_t k = 0; k < points.size(); ++k) ASSERT_EQ(points[k], static_cast<int>(k));
  std::vector<std::int32_t> parent(dissection.parts.size(), -1);
  std::int32_t end = 0;
  for (std::size_t k = 0; k < dissection.parts.size(); ++k) {
    ASSERT_EQ(dissection.parts[k].first, end);
    end = dissection.parts[k].end;
    for (const std::int32_t child : dissection.parts[k].children) {
      ASSERT_LT(child, static_cast<std::int32_t>(k));
      parent[static_cast<std::size_t>(child)] = static_cast<std::int32_t>(k);
    }
  }
  ASSERT_EQ(end, static_cast<std::int32_t>(points.size()));
  const std::vector<std::int32_t> part = parts_of(dissection);
  for (const Bond& bond : lattice.bonds) {
    const auto ends = std::minmax(part[static_cast<std::size_t>(bond.first)],
                                  part[static_cast<std::size_t>(bond.second)]);
    std::int32_t above = ends.first;
    while (above >= 0 && above < ends.second) above = parent[static_cast<std::size_t>(above)];
    EXPECT_EQ(above, ends.second);
  }
}

/// A side of 30 bonds: a straight line separates the patch by 30 points, an oblique row of it by no
/// fewer.
TEST(Dissect, SeparatesAPatch) {
  const Lattice patch = triangular_patch(60, 30);
  const Dissection dissection = dissect(patch.points, couplings_of(patch));
  expect_separated(patch, dissection);
  const Dissection::Part& last = dissection.parts.back();
  EXPECT_LE(last.end - last.first, 30);
}

Lattice shaken_patch(int columns, int rows, double distance) {
  Lattice lattice = triangular_patch(columns, rows);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-distance, distance);
  for (double& coordinate : lattice.points.reshaped()) coordinate += anywhere(random);
  return lattice;
}

/// Disorder roughens the cut: some 70 points lie beside a straight line, but 30 are enough.
TEST(Dissect, PushesTheSeparatorUntilItIsShort) {
  const Lattice lattice = shaken_patch(60, 30, 2.5);
  const Dissection dissection = dissect(lattice.points, couplings_of(lattice));
  expect_separated(lattice, dissection);
  EXPECT_LE(dissection.parts.back().end - dissection.parts.back().first, 31);
}

/// Where points lie says little of their bonds.
TEST(Dissect, SeparatesWhatLiesAnywhere) {
  const Lattice lattice = shaken_patch(40, 40, 20.0);
  expect_separated(lattice, dissect(lattice.points, couplings_of(lattice)));
}

/// Parts without a bond between them have an empty separator; a chain has one of a point.
TEST(Dissect, SeparatesChainsWithoutABondBetweenThem) {
  constexpr int kPoints = 100;
  PointArray points(2 * kPoints, 2);
  std::vector<Bond> bonds;
  for (int i = 0; i < kPoints; ++i) {
    points.row(i) << i, 0;
    points.row(kPoints + i) << i, 200;
    if (i == 0) continue;
    bonds.push_back({i - 1, i});
    bonds.push_back({kPoints + i - 1, kPoints + i});
  }
  const Lattice chains = plain_lattice(points, bonds);
  const Dissection dissection = dissect(chains.points, couplings_of(chains));
  expect_separated(chains, dissection);
  const auto& last = dissection.parts.back();
  EXPECT_EQ(last.first, last.end);
  for (const std::int32_t child : last.children) {
    const auto& part = dissection.parts[static_cast<std::size_t>(child)];
    EXPECT_EQ(part.end - part.first, 1);
  }
}

}  // namespace
}  // namespace impact
