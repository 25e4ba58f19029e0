#include "lattice/placement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "expect_input_error.hpp"

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

class EveryDisk : public testing::TestWithParam<PlacementRecipe> {};

TEST_P(EveryDisk, FillsTheDiskWithNPoints) {
  const PointArray points = place_in_disk(GetParam(), 3);
  EXPECT_EQ(points.rows(), GetParam().points);
  EXPECT_LE(points.square().rowwise().sum().maxCoeff(), 1.0 + 1e-12);
}

TEST_P(EveryDisk, DependsOnTheSeedAlone) {
  const PointArray points = place_in_disk(GetParam(), 3);
  EXPECT_TRUE((points == place_in_disk(GetParam(), 3)).all());
  EXPECT_FALSE((points == place_in_disk(GetParam(), 4)).all());
}

TEST_P(EveryDisk, HasItsRim) {
  const int n = GetParam().points;
  const double spacing = std::sqrt(M_PI / n);
  const int expected = GetParam().rim ? std::min(n, static_cast<int>(2.0 * M_PI / spacing)) : 0;
  EXPECT_EQ(count_on_rim(place_in_disk(GetParam(), 3)), expected);
}

INSTANTIATE_TEST_SUITE_P(Placement, EveryDisk,
                         testing::Values(PlacementRecipe{},
                                         PlacementRecipe{1099, Placement::kUniform, true},
                                         PlacementRecipe{1099, Placement::kUniform, false},
                                         PlacementRecipe{1099, Placement::kBlueNoise, false},
                                         PlacementRecipe{3, Placement::kBlueNoise, true},
                                         PlacementRecipe{3, Placement::kUniform, false},
                                         PlacementRecipe{14, Placement::kBlueNoise, true}));

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

constexpr double kRectangleWidth = 2.69;
constexpr double kRectangleHeight = 1.35;

class EveryRectangle : public testing::TestWithParam<PlacementRecipe> {};

TEST_P(EveryRectangle, IsFilledWithNPoints) {
  const PointArray points = place_in_rectangle(GetParam(), kRectangleWidth, kRectangleHeight, 3);
  EXPECT_EQ(points.rows(), GetParam().points);
  EXPECT_LE(points.col(0).abs().maxCoeff(), kRectangleWidth / 2.0);
  EXPECT_LE(points.col(1).abs().maxCoeff(), kRectangleHeight / 2.0);
}

TEST_P(EveryRectangle, DependsOnTheSeedAlone) {
  const PointArray points = place_in_rectangle(GetParam(), kRectangleWidth, kRectangleHeight, 3);
  EXPECT_TRUE(
      (points == place_in_rectangle(GetParam(), kRectangleWidth, kRectangleHeight, 3)).all());
  EXPECT_FALSE(
      (points == place_in_rectangle(GetParam(), kRectangleWidth, kRectangleHeight, 4)).all());
}

/// The sides are found by comparison, so their points lie on them exactly.
TEST_P(EveryRectangle, HasItsRimExactlyOnItsSides) {
  const PointArray points = place_in_rectangle(GetParam(), kRectangleWidth, kRectangleHeight, 3);
  const double spacing = std::sqrt(kRectangleWidth * kRectangleHeight / GetParam().points);
  const auto on_row = GetParam().rim ? std::lround(kRectangleWidth / spacing) + 1 : 0;
  const auto on_column = GetParam().rim ? std::lround(kRectangleHeight / spacing) + 1 : 0;
  EXPECT_EQ((points.col(1) == kRectangleHeight / 2.0).count(), on_row);
  EXPECT_EQ((points.col(1) == -kRectangleHeight / 2.0).count(), on_row);
  EXPECT_EQ((points.col(0) == kRectangleWidth / 2.0).count(), on_column);
  EXPECT_EQ((points.col(0) == -kRectangleWidth / 2.0).count(), on_column);
}

INSTANTIATE_TEST_SUITE_P(Placement, EveryRectangle,
                         testing::Values(PlacementRecipe{1269, Placement::kBlueNoise, true},
                                         PlacementRecipe{1269, Placement::kUniform, true},
                                         PlacementRecipe{1269, Placement::kBlueNoise, false},
                                         PlacementRecipe{1269, Placement::kUniform, false},
                                         PlacementRecipe{30, Placement::kBlueNoise, true},
                                         PlacementRecipe{3, Placement::kBlueNoise, false}));

/// s = 0.1 R, so that the rim of the 2 R by 1 R rectangle has 60 points 0.1 R apart.
TEST(PlacementInARectangle, SpacesItsRimEvenly) {
  const PointArray rim =
      place_in_rectangle({200, Placement::kUniform, true}, 2.0, 1.0, 1).topRows(60);
  EXPECT_TRUE((rim.col(0).abs() == 1.0 || rim.col(1).abs() == 0.5).all());
  EXPECT_NEAR(shortest_distance(rim), 0.1, 1e-14);
}

TEST(PlacementInARectangle, BlueNoiseKeepsItsDistance) {
  for (const bool rim : {true, false}) {
    const PointArray points = place_in_rectangle({1269, Placement::kBlueNoise, rim},
                                                 kRectangleWidth, kRectangleHeight, 5);
    EXPECT_GE(shortest_distance(points),
              0.6 * std::sqrt(kRectangleWidth * kRectangleHeight / 1269));
  }
}

/// Uniform points: the mean of x/width is 0 ± 1/√(12 N); that of its square is 1/12 ± 1/√(180 N).
TEST(PlacementInARectangle, UniformPointsAreUniform) {
  const int n = 100000;
  PointArray points =
      place_in_rectangle({n, Placement::kUniform, false}, kRectangleWidth, kRectangleHeight, 5);
  points.col(0) /= kRectangleWidth;
  points.col(1) /= kRectangleHeight;
  for (const int column : {0, 1}) {
    EXPECT_NEAR(points.col(column).mean(), 0.0, 5.0 / std::sqrt(12.0 * n));
    EXPECT_NEAR(points.col(column).square().mean(), 1.0 / 12.0, 5.0 / std::sqrt(180.0 * n));
  }
}

TEST(PlacementInARectangle, RefusesARimThatNeedsMorePoints) {
  EXPECT_INPUT_ERROR(place_in_rectangle({15, Placement::kUniform, true}, 4.0, 4.0, 1),
                     "the rim of a 4 by 4 R rectangle of 15 points needs 16 points");
  EXPECT_EQ(place_in_rectangle({16, Placement::kUniform, true}, 4.0, 4.0, 1).rows(), 16);
}

/// The rectangle of 600 points with its eight images around it.
TEST(PlacementInAPeriodicRectangle, BlueNoiseKeepsItsDistanceAcrossTheSides) {
  const int n = 600;
  const PointArray points =
      place_in_periodic_rectangle(n, Placement::kBlueNoise, kRectangleWidth, kRectangleHeight, 5);
  EXPECT_LE(points.col(0).abs().maxCoeff(), kRectangleWidth / 2.0);
  EXPECT_LE(points.col(1).abs().maxCoeff(), kRectangleHeight / 2.0);
  PointArray tiled(9 * n, 2);
  for (int image = 0; image < 9; ++image) {
    tiled.middleRows(n * image, n).col(0) = points.col(0) + kRectangleWidth * (image % 3);
    tiled.middleRows(n * image, n).col(1) = points.col(1) + kRectangleHeight * (image / 3);
  }
  const double rounding = 1e-14;  // of the images' coordinates
  EXPECT_GE(shortest_distance(tiled),
            0.6 * std::sqrt(kRectangleWidth * kRectangleHeight / n) - rounding);
}

TEST(PlacementInAPeriodicRectangle, DependsOnTheSeedAlone) {
  for (const Placement placement : {Placement::kUniform, Placement::kBlueNoise}) {
    const auto place = [&](std::uint64_t seed) {
      return place_in_periodic_rectangle(100, placement, kRectangleWidth, kRectangleHeight, seed);
    };
    EXPECT_TRUE((place(3) == place(3)).all());
    EXPECT_FALSE((place(3) == place(4)).all());
  }
}

}  // namespace
}  // namespace impact
