#include "output/csv.hpp"

#include <gtest/gtest.h>

namespace impact {
namespace {

TEST(Csv, QuotesOnlyWhatNeedsIt) {
  EXPECT_EQ(csv_cell("a b; 1.5"), "a b; 1.5");
  EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_cell("say \"a\"\n"), "\"say \\\"a\\\"\\n\"");
}

TEST(Csv, ReadsWhatItWrites) {
  const std::vector<std::string> texts{"", "a,b", "\"", "\\", "two\nlines", "plain"};
  EXPECT_EQ(cells_of(csv_line(texts)), texts);
}

}  // namespace
}  // namespace impact
