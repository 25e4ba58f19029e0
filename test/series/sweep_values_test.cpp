#include "series/sweep_values.hpp"

#include <gtest/gtest.h>

#include "expect_input_error.hpp"

namespace impact {
namespace {

using Texts = std::vector<std::string>;

TEST(SweepValues, TakesOneValueOrAList) {
  EXPECT_EQ(sweep_values("impact.gap", "auto"), (Texts{"auto"}));
  EXPECT_EQ(sweep_values("impact.gap", "auto,0.1,2"), (Texts{"auto", "0.1", "2"}));
}

TEST(SweepValues, DividesARangeEvenly) {
  EXPECT_EQ(sweep_values("impact.velocity", "0.1:0.5:5"),
            (Texts{"0.1", "0.2", "0.3", "0.4", "0.5"}));
  EXPECT_EQ(sweep_values("impact.velocity", "0.5:0.1:3"), (Texts{"0.5", "0.3", "0.1"}));
  EXPECT_EQ(sweep_values("impact.velocity", "0.1:0.1:1"), (Texts{"0.1"}));
  EXPECT_EQ(sweep_values("seed", "1:4:4"), (Texts{"1", "2", "3", "4"}));
}

TEST(SweepValues, DividesALogarithmicRangeByEqualRatios) {
  EXPECT_EQ(sweep_values("impact.velocity", "0.001:1:4:log"), (Texts{"0.001", "0.01", "0.1", "1"}));
  EXPECT_EQ(sweep_values("impact.velocity", "0.003:0.05:3:log"),
            (Texts{"0.003", "0.0122474487139", "0.05"}));  // √(0.003 · 0.05) to 12 digits
}

TEST(SweepValues, KeepsWholeNumbersWhole) {
  EXPECT_EQ(sweep_values("disk.points", "10:1000:3:log"), (Texts{"10", "100", "1000"}));
  EXPECT_EQ(sweep_values("disk.points", "100:200:4"), (Texts{"100", "133", "167", "200"}));
}

TEST(SweepValues, RefusesOtherRanges) {
  for (const char* text : {"1:2", "1:2:3:lin", "1:2:3:log:4", "1:2:0", "1:2:x", "1:2:2.5", "a:2:3",
                           "0:1:3:log", "1:2:1", "1:1:2", "1:.inf:3", ":2:3"}) {
    EXPECT_INPUT_ERROR(sweep_values("load.P", text),
                       std::string("load.P: got ") + text + ", allowed: lo:hi:n or lo:hi:n:log");
  }
  EXPECT_INPUT_ERROR(sweep_values("seed", "1:010:10"), "seed: got 1:010:10, allowed: lo:hi:n");
}

/// A double has 53 digits.
TEST(SweepValues, RefusesRangesThatWouldBeRounded) {
  EXPECT_EQ(sweep_values("seed", "9007199254740990:9007199254740992:3")[1], "9007199254740991");
  EXPECT_INPUT_ERROR(sweep_values("seed", "9007199254740993:9007199254740999:7"),
                     "allowed: a range within ±2^53, or a list of values");
  EXPECT_EQ(sweep_values("seed", "9007199254740993,9007199254740995")[0], "9007199254740993");
}

TEST(ParseSweep, RefusesAValueTwiceHoweverItIsWritten) {
  const FlatTree keys = flatten(YAML::Load("{scene: collision}"));
  EXPECT_INPUT_ERROR(parse_sweep(keys, {"seed=1,2,1"}),
                     "seed: got [1, 2, 1], allowed: no value twice");
  EXPECT_INPUT_ERROR(parse_sweep(keys, {"seed=1:3:4"}),
                     "seed: got [1, 2, 2, 3], allowed: no value twice");
  EXPECT_INPUT_ERROR(parse_sweep(keys, {"impact.velocity=0.01,1e-2"}), "allowed: no value twice");
  EXPECT_EQ(parse_sweep(keys, {"seed=9007199254740993,9007199254740992"}).size(), 2U);
}

TEST(SweepValues, TakesAColonInAPath) {
  EXPECT_EQ(sweep_values("disk.file", "/a:b/c.data"), (Texts{"/a:b/c.data"}));
}

TEST(SweepValues, RefusesBrackets) {
  EXPECT_INPUT_ERROR(sweep_values("impact.velocity", "[0.1,0.2]"),
                     "impact.velocity: got [0.1,0.2], allowed: v1,v2,… or lo:hi:n");
}

TEST(ParseSweep, LetsTheLastKeyChangeFastest) {
  const FlatTree keys = flatten(YAML::Load("{scene: collision, seed: 9, material: {eta: 3}}"));
  const auto scenes = parse_sweep(keys, {"seed=1,2", "impact.velocity=0.01:0.03:3"});
  ASSERT_EQ(scenes.size(), 6U);
  EXPECT_EQ(scenes[1].seed, 1U);
  EXPECT_EQ(scenes[1].impact.velocity, 0.02);
  EXPECT_EQ(scenes[3].seed, 2U);
  EXPECT_EQ(scenes[3].impact.velocity, 0.01);
  EXPECT_EQ(scenes[5].material.eta, 3.0);
  EXPECT_EQ(parse_sweep(keys, {}).size(), 1U);
}

TEST(ParseSweep, RefusesWhatIsNoSweep) {
  const FlatTree keys = flatten(YAML::Load("{scene: collision}"));
  EXPECT_INPUT_ERROR(parse_sweep(keys, {"seed"}), "seed: allowed: key=values");
  EXPECT_INPUT_ERROR(parse_sweep(keys, {"=1"}), "=1: allowed: key=values");
  EXPECT_INPUT_ERROR(parse_sweep(keys, {"seed=1", "seed=2"}), "seed: given twice");
  EXPECT_INPUT_ERROR(parse_sweep(keys, {"seed=1,,2"}), "seed: got nothing, allowed");
  EXPECT_INPUT_ERROR(parse_sweep(keys, {"impact.velocity=0.5:1.5:3"}), "impact.velocity: got 1.5");
  EXPECT_INPUT_ERROR(parse_sweep(keys, {"seed=1:1000:1000", "wall.a=1:101:101"}),
                     "wall.a: more than 100000 combinations");
}

}  // namespace
}  // namespace impact
