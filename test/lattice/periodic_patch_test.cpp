#include "lattice/periodic_patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "expect_input_error.hpp"

namespace impact {
namespace {

constexpr double kWidth = 2.0;
constexpr double kHeight = 1.5;

/// Euler's formula on the torus: faces − edges + points = 0 and 2 edges = 3 faces.
TEST(PeriodicPatch, HasThreeBondsAPointEachPairOnce) {
  for (const Placement placement : {Placement::kUniform, Placement::kBlueNoise}) {
    PeriodicPatch patch = random_patch(500, placement, kWidth, kHeight, 7);
    EXPECT_EQ(patch.bonds.size(), 1500U);
    for (const Bond& bond : patch.bonds) EXPECT_LT(bond.first, bond.second);
    std::sort(patch.bonds.begin(), patch.bonds.end());
    EXPECT_EQ(std::adjacent_find(patch.bonds.begin(), patch.bonds.end()), patch.bonds.end());
  }
}

/// A bond vector is r_first − r_second up to whole widths and heights, and the shortest of these.
TEST(PeriodicPatch, BondVectorsLeadToTheNearestImage) {
  const PeriodicPatch patch = random_patch(500, Placement::kBlueNoise, kWidth, kHeight, 7);
  int across = 0;
  for (std::size_t k = 0; k < patch.bonds.size(); ++k) {
    const auto vector = patch.bond_vectors.row(static_cast<Eigen::Index>(k));
    const Eigen::Array2d inside =
        (patch.points.row(patch.bonds[k].first) - patch.points.row(patch.bonds[k].second))
            .transpose();
    const double rounding = 1e-14;
    EXPECT_NEAR(vector.x(), std::remainder(inside.x(), kWidth), rounding);
    EXPECT_NEAR(vector.y(), std::remainder(inside.y(), kHeight), rounding);
    if (inside.abs().maxCoeff() > kHeight / 2.0) ++across;
  }
  EXPECT_GT(across, 0);
}

/// Where the sides lie is arbitrary: points shifted round the torus have the same bonds.
TEST(PeriodicPatch, KeepsItsBondsWhenShifted) {
  PeriodicPatch patch = random_patch(300, Placement::kUniform, kWidth, kHeight, 2);
  PointArray points = patch.points;
  points.col(0) =
      (points.col(0) + 0.7).unaryExpr([](double x) { return std::remainder(x, kWidth); });
  points.col(1) =
      (points.col(1) - 0.4).unaryExpr([](double y) { return std::remainder(y, kHeight); });
  PeriodicPatch shifted = triangulated_patch(points, kWidth, kHeight);
  std::sort(patch.bonds.begin(), patch.bonds.end());
  std::sort(shifted.bonds.begin(), shifted.bonds.end());
  EXPECT_EQ(patch.bonds, shifted.bonds);
}

TEST(PeriodicPatch, DependsOnTheSeedAlone) {
  const auto points = [](std::uint64_t seed) {
    return random_patch(100, Placement::kBlueNoise, kWidth, kHeight, seed).points;
  };
  EXPECT_TRUE((points(3) == points(3)).all());
  EXPECT_FALSE((points(3) == points(4)).all());
}

TEST(PeriodicPatch, RefusesTooFewPoints) {
  EXPECT_INPUT_ERROR(random_patch(3, Placement::kBlueNoise, 1.0, 1.0, 1),
                     "3 points are too few for a periodic patch of 1 by 1 R");
}

}  // namespace
}  // namespace impact
