#include "output/text_table.hpp"

#include <gtest/gtest.h>

namespace impact {
namespace {

TEST(Aligned, CountsCharactersNotBytes) {
  EXPECT_EQ(display_width("M c²/R"), 6U);
  EXPECT_EQ(aligned({{"c²", "x"}, {"1", "10"}}), "c²   x\n 1  10\n");
}

}  // namespace
}  // namespace impact
