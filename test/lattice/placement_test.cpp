#include "lattice/placement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace impact {
namespace {

double shortest_distance(const PointArray& points) {
  double shortest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 1; i < points.rows(); ++i) {
    const auto offset = points.topRows(i).rowwise() - points.row(i);
    shortest = std::min(shortest, offset.square().rowwise().sum().minCoeff());
  }
  return std::sqrt(shortest);
}

Eigen::Index count_on_rim(const PointArray& points) {
  return ((points.square().rowwise().sum() - 1.0).abs() < 1e-12).count();
}

class EveryRecipe : public testing::TestWithParam<DiskRecipe> {};

TEST_P(EveryRecipe, FillsTheDiskWithNPoints) {
  const PointArray points = place_in_disk(GetParam(), 3);
  EXPECT_EQ(points.rows(), GetParam().points);
  EXPECT_LE(points.square().rowwise().sum().maxCoeff(), 1.0 + 1e-12);
}

TEST_P(EveryRecipe, DependsOnTheSeedAlone) {
  const PointArray points = place_in_disk(GetParam(), 3);
  EXPECT_TRUE((points == place_in_disk(GetParam(), 3)).all());
  EXPECT_FALSE((points == place_in_disk(GetParam(), 4)).all());
}

TEST_P(EveryRecipe, HasItsRim) {
  const int n = GetParam().points;
  const double spacing = std::sqrt(M_PI / n);
  const int expected = GetParam().rim ? std::min(n, static_cast<int>(2.0 * M_PI / spacing)) : 0;
  EXPECT_EQ(count_on_rim(place_in_disk(GetParam(), 3)), expected);
}

INSTANTIATE_TEST_SUITE_P(Placement, EveryRecipe,
                         testing::Values(DiskRecipe{}, DiskRecipe{1099, Placement::kUniform, true},
                                         DiskRecipe{1099, Placement::kUniform, false},
                                         DiskRecipe{1099, Placement::kBlueNoise, false},
                                         DiskRecipe{3, Placement::kBlueNoise, true},
                                         DiskRecipe{3, Placement::kUniform, false},
                                         DiskRecipe{14, Placement::kBlueNoise, true}));

TEST(Placement, BlueNoiseKeepsItsDistance) {
  for (const bool rim : {true, false}) {
    const PointArray points = place_in_disk({1099, Placement::kBlueNoise, rim}, 5);
    EXPECT_GE(shortest_distance(points), 0.6 * std::sqrt(M_PI / 1099));
  }
}

/// Uniform points: r² is uniform on [0, 1], so its mean over N points is 1/2 ± 1/√(12 N).
TEST(Placement, UniformPointsAreUniform) {
  const int n = 100000;
  const PointArray points = place_in_disk({n, Placement::kUniform, false}, 5);
  const double five_sigma = 5.0 / std::sqrt(12.0 * n);
  EXPECT_NEAR(points.square().sum() / n, 0.5, five_sigma);
  EXPECT_NEAR(points.col(0).mean(), 0.0, 2.0 * five_sigma);
  EXPECT_NEAR(points.col(1).mean(), 0.0, 2.0 * five_sigma);
}

}  // namespace
}  // namespace impact
