#include "series/summary.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace impact {
namespace {

Row row(std::uint64_t seed, double velocity, double restitution, const std::string& flags = "") {
  Row row;
  row.scene.seed = seed;
  row.scene.impact.velocity = velocity;
  row.results = {{"restitution", restitution}, {"contact_duration", 5.0}};
  row.flags = flags;
  return row;
}

/// Of 0.5, 0.7, 0.9: mean 0.7, standard deviation 0.2, standard error 0.2/√3 = 0.115.
TEST(Summary, GivesMeanAndStandardErrorOverSeeds) {
  const std::vector<Row> rows{row(1, 0.01, 0.5), row(2, 0.01, 0.7, "not_separated"),
                              row(3, 0.01, 0.9), row(1, 0.0212345678912, 0.25)};
  EXPECT_EQ(
      summary(rows),
      "impact.velocity  runs  restitution  std_error  contact_duration  std_error  flagged\n"
      "           0.01     3         0.70       0.12                 5          0        1\n"
      "      0.0212346     1         0.25          -                 5          -        0\n");
}

TEST(Summary, LeavesOutRunsWithoutAResult) {
  const std::string text = summary({row(1, 0.01, 0.5), row(2, 0.01, std::nan(""), "failed: x")});
  EXPECT_EQ(text,
            "runs  restitution  std_error  contact_duration  std_error  flagged\n"
            "   2          0.5          -                 5          0        1\n");
}

TEST(Summary, HasALineARunWithoutSeveralSeeds) {
  EXPECT_EQ(summary({row(1, 0.01, 0.5), row(1, 0.02, 0.25, "step_reduced")}),
            "impact.velocity  restitution  contact_duration         flags\n"
            "           0.01          0.5                 5             -\n"
            "           0.02         0.25                 5  step_reduced\n");
}

}  // namespace
}  // namespace impact
