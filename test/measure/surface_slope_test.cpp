#include "measure/surface_slope.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace impact {
namespace {

std::vector<PointForce> pushed(const std::vector<std::int32_t>& points) {
  std::vector<PointForce> forces;
  for (const std::int32_t point : points) forces.push_back({point, {0.0, -1.0}});
  return forces;
}

/// A chain of six points along the direction `angle`, unevenly spaced.
PointArray straight_chain(double angle) {
  PointArray chain(6, 2);
  for (int k = 0; k < 6; ++k) {
    const double along = k + 0.3 * std::sin(2.0 * k);
    chain.row(k) << 1.0 + along * std::cos(angle), -2.0 + along * std::sin(angle);
  }
  return chain;
}

TEST(ChordSlope, OfAStraightChainIsItsOwnWhereverItIsPushed) {
  for (const double angle : {-0.4, 0.0, 0.1, 1.0}) {
    const PointArray chain = straight_chain(angle);
    for (const auto& points : {std::vector<std::int32_t>{0, 1}, {1, 2, 3}, {2, 5}}) {
      EXPECT_NEAR(chord_slope(pushed(points), chain), std::tan(angle), 1e-14);
    }
  }
}

/// The chord of an arc is perpendicular to the radius to the arc's middle.
TEST(ChordSlope, OfAnArcIsThatOfItsMiddle) {
  PointArray chain(5, 2);
  for (int k = 0; k < 5; ++k) {
    const double angle = 0.2 * (k - 1);
    chain.row(k) << std::sin(angle), -std::cos(angle);
  }
  EXPECT_NEAR(chord_slope(pushed({0, 1, 2}), chain), 0.0, 1e-15);
  EXPECT_NEAR(chord_slope(pushed({1, 2, 3}), chain), std::tan(0.2), 1e-14);
  EXPECT_NEAR(chord_slope(pushed({0, 1, 2, 3, 4}), chain), std::tan(0.2), 1e-14);
}

TEST(ChordSlope, NeedsTwoPoints) {
  EXPECT_TRUE(std::isnan(chord_slope(pushed({3}), straight_chain(0.1))));
  EXPECT_TRUE(std::isnan(chord_slope({}, straight_chain(0.1))));
}

TEST(SurfaceSlope, OfASteadySlopeIsThatSlope) {
  SurfaceSlope slope(2.0);
  for (const double time : {3.0, 3.5, 6.0}) slope.add(time, std::sqrt(time), 0.07);
  EXPECT_NEAR(slope.mean(), 0.07, 1e-16);
}

TEST(SurfaceSlope, IsWeightedByForceAndTime) {
  SurfaceSlope slope(1.0);
  slope.add(2.0, 3.0, 0.1);
  slope.add(4.0, 1.0, 0.4);
  EXPECT_NEAR(slope.mean(), (3.0 * 0.1 + 2.0 * 0.4) / 5.0, 1e-16);
}

/// The time without a slope belongs to no other one.
TEST(SurfaceSlope, LeavesOutWhereThereIsNone) {
  SurfaceSlope slope(0.0);
  EXPECT_TRUE(std::isnan(slope.mean()));
  slope.add(1.0, 1.0, 0.1);
  slope.add(3.0, 5.0, std::nan(""));
  slope.add(4.0, 1.0, 0.3);
  EXPECT_NEAR(slope.mean(), 0.2, 1e-16);
}

}  // namespace
}  // namespace impact
