#include "output/result.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace impact {
namespace {

Result sample() {
  return {{{"run", 3.0},
           {"complete", true},
           {"restitution", 0.1 + 0.2},
           {"tiny", 1e-10},
           {"unknown", std::nan("")},
           {"integrator", "verlet"},
           {"flags", std::vector<std::string>{"hops", "folded"}}}};
}

TEST(Result, IsFoundByKey) {
  EXPECT_EQ(sample().number("restitution"), 0.1 + 0.2);
  EXPECT_EQ(std::get<std::string>(*sample().find("integrator")), "verlet");
  EXPECT_EQ(sample().flags(), (std::vector<std::string>{"hops", "folded"}));
  EXPECT_TRUE(sample().has("complete"));
  EXPECT_FALSE(sample().has("strain"));
}

TEST(Result, WithoutANumberOrFlags) {
  EXPECT_TRUE(std::isnan(sample().number("strain")));
  EXPECT_TRUE(std::isnan(sample().number("integrator")));
  EXPECT_TRUE(Result{}.flags().empty());
}

TEST(Result, IsWrittenInItsOrderToTheLastBit) {
  EXPECT_EQ(YAML::Dump(to_yaml(sample())),
            "run: 3\n"
            "complete: true\n"
            "restitution: 0.30000000000000004\n"
            "tiny: 1.0e-10\n"
            "unknown: .nan\n"
            "integrator: verlet\n"
            "flags: [hops, folded]");
}

TEST(Result, IsReadBack) {
  const Result result = read_result(YAML::Load(YAML::Dump(to_yaml(sample()))));
  EXPECT_EQ(result.number("restitution"), 0.1 + 0.2);
  EXPECT_TRUE(std::isnan(result.number("unknown")));
  EXPECT_EQ(std::get<std::string>(*result.find("integrator")), "verlet");
  EXPECT_EQ(result.flags(), sample().flags());
}

TEST(Result, OfAForeignFileLacksWhatIsNoResult) {
  const Result result = read_result(YAML::Load("{a: {b: 1}, [c]: 2, flags: 3, d: ~}"));
  EXPECT_FALSE(result.has("a"));
  EXPECT_FALSE(result.has("d"));
  EXPECT_TRUE(result.flags().empty());
}

}  // namespace
}  // namespace impact
