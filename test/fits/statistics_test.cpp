#include "fits/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace impact {
namespace {

TEST(MeanPoint, ByHand) {
  const MeanPoint point = mean_point(0.5, {1.0, 2.0, 6.0});
  EXPECT_EQ(point.x, 0.5);
  EXPECT_EQ(point.runs, 3U);
  EXPECT_DOUBLE_EQ(point.y, 3.0);
  EXPECT_DOUBLE_EQ(point.standard_error, std::sqrt((4.0 + 1.0 + 9.0) / 2.0 / 3.0));
}

TEST(MeanPoint, OfOneValueHasNoStandardError) {
  const MeanPoint point = mean_point(0.5, {0.9});
  EXPECT_EQ(point.y, 0.9);
  EXPECT_TRUE(std::isnan(point.standard_error));
}

TEST(JackknifeError, ByHand) {
  EXPECT_DOUBLE_EQ(jackknife_error({1.0, 2.0, 6.0}), std::sqrt(2.0 / 3.0 * (4.0 + 1.0 + 9.0)));
}

TEST(Quantile, LiesBetweenTheValues) {
  EXPECT_DOUBLE_EQ(quantile({1.0, 2.0, 4.0}, 0.5), 2.0);
  EXPECT_DOUBLE_EQ(quantile({1.0, 2.0, 4.0}, 0.75), 3.0);
  EXPECT_DOUBLE_EQ(quantile({1.0, 2.0, 4.0}, 1.0), 4.0);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(Median, IsTheMiddleOrTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({4.0, 1.0, 3.0, 2.0}), 2.5);
}

}  // namespace
}  // namespace impact
