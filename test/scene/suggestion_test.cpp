#include "scene/suggestion.hpp"

#include <gtest/gtest.h>

namespace impact {
namespace {

/// Known values of the optimal string alignment distance; it is symmetric.
TEST(TypingDistance, CountsWhatWasTypedWrongly) {
  const auto distance = [](std::string_view a, std::string_view b) {
    EXPECT_EQ(typing_distance(a, b), typing_distance(b, a));
    return typing_distance(a, b);
  };
  EXPECT_EQ(distance("", ""), 0U);
  EXPECT_EQ(distance("", "abc"), 3U);
  EXPECT_EQ(distance("velocity", "velocity"), 0U);
  EXPECT_EQ(distance("velocty", "velocity"), 1U);   // left out
  EXPECT_EQ(distance("velozity", "velocity"), 1U);  // replaced
  EXPECT_EQ(distance("veloctiy", "velocity"), 1U);  // swapped
  EXPECT_EQ(distance("kitten", "sitting"), 3U);
  EXPECT_EQ(distance("ca", "abc"), 3U);  // the unrestricted distance would be 2
}

TEST(Suggestion, NamesTheNearestKey) {
  const std::vector<std::string> keys{"scene",  "seed",   "disk.points",     "material.eta",
                                      "wall.a", "load.P", "impact.velocity", "impact.gap"};
  EXPECT_EQ(suggestion("impact.velocty", keys), " (did you mean impact.velocity?)");
  EXPECT_EQ(suggestion("imapct.velocity", keys), " (did you mean impact.velocity?)");
  EXPECT_EQ(suggestion("velocty", keys), " (did you mean impact.velocity?)");
  EXPECT_EQ(suggestion("sead", keys), " (did you mean seed?)");
  EXPECT_EQ(suggestion("eat", keys), " (did you mean material.eta?)");
  EXPECT_EQ(suggestion("collision.velocity", keys), " (did you mean impact.velocity?)");
}

TEST(Suggestion, IsSilentWhereNothingIsNear) {
  const std::vector<std::string> keys{"wall.a", "impact.gap", "seed"};
  EXPECT_EQ(suggestion("load.P", keys), "");
  EXPECT_EQ(suggestion("impact.angle", keys), "");
  EXPECT_EQ(suggestion("N", keys), "");
  EXPECT_EQ(suggestion("", keys), "");
  EXPECT_EQ(suggestion(std::string(100000, 's'), keys), "");
  EXPECT_EQ(suggestion("seed", {}), "");
}

}  // namespace
}  // namespace impact
