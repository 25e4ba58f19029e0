#include "verification/pareto.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace impact {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(ParetoFront, LeavesOutWhatAnotherPointBeats) {
  const std::vector<WorkAndError> points{{3.0, 1e-6}, {1.0, 1e-2}, {2.0, 1e-2}, {4.0, 1e-5},
                                         {2.5, kNaN}, {5.0, 1e-9}, {3.0, 1e-4}};
  EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{1, 0, 5}));
}

TEST(ParetoFront, TakesTheFirstOfEqualPoints) {
  EXPECT_EQ(pareto_front({{1.0, 1e-2}, {1.0, 1e-2}}), std::vector<std::size_t>{0});
}

TEST(ParetoFront, OfNoAnswersIsEmpty) {
  EXPECT_TRUE(pareto_front({{1.0, kNaN}, {2.0, kNaN}}).empty());
}

TEST(LeastWork, IsOfThePointsWithinTheError) {
  const std::vector<WorkAndError> points{{1.0, 1e-2}, {0.5, kNaN}, {3.0, 1e-6}, {2.0, 1e-4}};
  EXPECT_EQ(least_work(points, 1e-2), 0U);
  EXPECT_EQ(least_work(points, 1e-4), 3U);
  EXPECT_EQ(least_work(points, 1e-5), 2U);
  EXPECT_EQ(least_work(points, 1e-7), std::nullopt);
}

TEST(CoarsestSufficient, SkipsWhatIsGoodByChance) {
  const std::vector<double> errors{1e-8, 1e-3, 1e-5, 1e-7};
  EXPECT_EQ(coarsest_sufficient(errors, 1e-2), 0U);
  EXPECT_EQ(coarsest_sufficient(errors, 1e-5), 2U);
  EXPECT_EQ(coarsest_sufficient(errors, 1e-9), std::nullopt);
  EXPECT_EQ(coarsest_sufficient({}, 1.0), std::nullopt);
}

TEST(CoarsestSufficient, DoesNotTakeARunWithoutAnswer) {
  EXPECT_EQ(coarsest_sufficient({kNaN, 1e-5}, 1e-4), 1U);
  EXPECT_EQ(coarsest_sufficient({1e-5, kNaN}, 1e-4), std::nullopt);
}

}  // namespace
}  // namespace impact
