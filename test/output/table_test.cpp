#include "output/table.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

namespace impact {
namespace {

TEST(Table, WritesLinesOfNumbersAndTexts) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "table.csv";
  Table table({"name", "value"});
  table << "a third" << 1.0 / 3.0 << "nothing" << -std::numeric_limits<double>::quiet_NaN();
  table.write(path);
  std::ifstream file(path);
  const std::string content{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(content, "name,value\na third,0.3333333333333333\nnothing,nan\n");
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".part"));
}

/// /dev/full takes nothing.
TEST(Table, LeavesTheOldOneWhereThereIsNoSpace) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "old_table.csv";
  for (const char* const end : {"", ".part"}) std::filesystem::remove(path.string() + end);
  std::ofstream(path) << "old\n";
  std::filesystem::create_symlink("/dev/full", path.string() + ".part");
  EXPECT_THROW(Table({"x"}).write(path), std::runtime_error);
  ASSERT_TRUE(std::filesystem::is_regular_file(path));
  std::ifstream file(path);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "old\n");
}

TEST(Table, SaysWhenItCannotBeWritten) {
  EXPECT_THROW(Table({"x"}).write("/no/such/folder/table.csv"), std::runtime_error);
}

}  // namespace
}  // namespace impact
