#include "reproduction/reproduction.hpp"

#include <gtest/gtest.h>

#include "reproduction/restitution_curve.hpp"

namespace impact {
namespace {

/// A larger ensemble begins with the smaller one, so that its runs are taken up.
TEST(WithSeeds, GrowsAtTheEnd) {
  const std::vector<Scene> scenes = at_all_speeds({});
  const auto three = with_seeds(scenes, 3);
  const auto two = with_seeds(scenes, 2);
  ASSERT_EQ(three.size(), 3 * scenes.size());
  for (std::size_t i = 0; i < two.size(); ++i) {
    EXPECT_EQ(two[i].seed, three[i].seed);
    EXPECT_EQ(two[i].impact.velocity, three[i].impact.velocity);
  }
  EXPECT_EQ(three.back().seed, 3U);
}

}  // namespace
}  // namespace impact
