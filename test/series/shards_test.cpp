#include "series/shards.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "expect_input_error.hpp"
#include "run/bodies.hpp"
#include "run/forecast.hpp"
#include "scene/version.hpp"
#include "small_scenes.hpp"

namespace impact {
namespace {

namespace fs = std::filesystem;

using Division = std::vector<std::vector<std::size_t>>;

std::vector<double> loads(const std::vector<Scene>& series, const Division& shards) {
  std::vector<double> all;
  for (const auto& rows : shards) {
    all.push_back(std::accumulate(rows.begin(), rows.end(), 0.0, [&](double sum, std::size_t row) {
      return sum + forecast(series[row]).seconds;
    }));
  }
  return all;
}

/// The load of the fullest shard over the mean.
double imbalance(const std::vector<double>& loads) {
  const double sum = std::accumulate(loads.begin(), loads.end(), 0.0);
  return *std::max_element(loads.begin(), loads.end()) / sum * static_cast<double>(loads.size());
}

/// Every row of the series in one shard, and the rows of each rising.
void expect_division(const Division& shards, std::size_t rows) {
  std::vector<std::size_t> all;
  for (const auto& shard : shards) {
    EXPECT_TRUE(std::is_sorted(shard.begin(), shard.end()));
    all.insert(all.end(), shard.begin(), shard.end());
  }
  std::sort(all.begin(), all.end());
  std::vector<std::size_t> expected(rows);
  std::iota(expected.begin(), expected.end(), std::size_t{0});
  EXPECT_EQ(all, expected);
}

std::set<std::string> lattices_of(const std::vector<Scene>& series,
                                  const std::vector<std::size_t>& rows) {
  std::set<std::string> keys;
  for (const std::size_t row : rows) keys.insert(key_of_bodies(series[row]));
  return keys;
}

TEST(Divide, LeavesLatticesWhole) {
  const auto series = scenes(
      "{scene: collision, impact: {velocity: [0.003, 0.01, 0.05]}, "
      "seed: [1, 2, 3, 4, 5, 6, 7, 8]}");
  const Division shards = divide(series, 4);
  expect_division(shards, series.size());
  for (const auto& rows : shards) {
    EXPECT_EQ(rows.size(), 6);
    EXPECT_EQ(lattices_of(series, rows).size(), 2);
  }
}

/// A lattice with four runs and four with one.
TEST(Divide, BalancesTimeAndNotNumberOfLattices) {
  std::vector<Scene> series = scenes("{scene: collision, seed: [1, 2, 3, 4, 5]}");
  series.insert(series.begin(), 3, series.front());
  const Division shards = divide(series, 2);
  expect_division(shards, series.size());
  EXPECT_LT(imbalance(loads(series, shards)), 1.01);
}

/// One run that takes as long as many of a coarse lattice.
TEST(Divide, BalancesTimeAndNotNumberOfRuns) {
  std::vector<Scene> series = scenes("{scene: collision, disk: {points: 4000}}");
  const auto quick = scenes(
      "{scene: collision, disk: {points: 400}, seed: [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, "
      "14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30]}");
  series.insert(series.end(), quick.begin(), quick.end());
  const Division shards = divide(series, 2);
  expect_division(shards, series.size());
  EXPECT_LT(imbalance(loads(series, shards)), 1.1);
  EXPECT_GT(shards[1].size(), 2 * shards[0].size());
}

/// Speeds of very unequal cost on one lattice. The bound: no more than the mean and one piece,
/// which is half a mean and one run, of which the slowest is a tenth of a mean.
TEST(Divide, CutsALatticeThatIsMoreThanAShare) {
  std::string speeds = "0.004";
  for (int i = 1; i < 200; ++i) speeds += fmt::format(", {}", 0.004 * std::pow(1.01, i));
  const auto series = scenes("{scene: collision, impact: {velocity: [" + speeds + "]}}");
  const Division shards = divide(series, 4);
  expect_division(shards, series.size());
  EXPECT_LT(imbalance(loads(series, shards)), 1.3);
  for (const auto& rows : shards) EXPECT_GE(rows.size(), 8);  // lanes
}

TEST(Divide, LeavesShardsEmptyRatherThanLanes) {
  const auto series = scenes(
      "{scene: collision, impact: {velocity: [0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08, "
      "0.09, 0.1]}}");
  const Division shards = divide(series, 5);
  expect_division(shards, series.size());
  EXPECT_EQ(shards[0].size(), series.size());
}

TEST(ParseShard, RefusesWhatIsNone) {
  EXPECT_EQ(text(parse_shard("3/16")), "3/16");
  for (const char* const wrong :
       {"", "3", "0/4", "5/4", "1/0", "-1/4", "1/100001", "1/4 ", "a/b"}) {
    EXPECT_INPUT_ERROR(parse_shard(wrong), "--shard: got ");
  }
}

class Shards : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::remove(file_);
    fs::remove(whole_);
  }
  void run(const Shard& shard) const { series_.run(shard, {}); }
  void run_all(std::size_t count) const {
    for (std::size_t k = 1; k <= count; ++k) run({k, count});
  }
  std::string shard_file(int number, int count) const {
    return fmt::format("{}/shard-{}-of-{}.csv", folder_, number, count);
  }
  std::string collected() const {
    series_.collect(file_);
    return without_wall_time(content(file_));
  }
  std::string undivided() const {
    run_series(small_scenes(), whole_, {});
    return without_wall_time(content(whole_));
  }
  void expect_not_collected(const std::string& reason) const {
    try {
      series_.collect(file_);
      ADD_FAILURE() << "collected";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(error.what(), folder_ + ": " + reason);
    }
    EXPECT_FALSE(fs::exists(file_));
  }

  std::string folder_ = testing::TempDir() + "shards";
  std::string file_ = testing::TempDir() + "collected.csv";
  std::string whole_ = testing::TempDir() + "undivided.csv";
  ShardedSeries series_{small_scenes(), folder_};
};

TEST_F(Shards, AreTogetherTheUndividedSeries) {
  run_all(2);
  EXPECT_EQ(collected(), undivided());
  EXPECT_NE(content(shard_file(2, 2)).find(fmt::format("\n{},2,collision,", version())),
            std::string::npos);
}

/// A contact has columns that a collision has not; the last one fails with a text in quotes.
TEST_F(Shards, HaveTheColumnsOfAll) {
  std::vector<Scene> mixed = small_scenes();
  for (const char* const yaml :
       {"{scene: contact, disk: {points: 40}, numerics: {integrator: newton}}",
        "{scene: collision, disk: {points: 50}, impact: {gap: -1}}"}) {
    mixed.push_back(scenes(yaml).front());
  }
  const ShardedSeries series(mixed, folder_);
  for (std::size_t k = 1; k <= 3; ++k) series.run({k, 3}, {});
  EXPECT_TRUE(has_failed(series.collect(file_).back()));
  run_series(mixed, whole_, {});
  EXPECT_EQ(without_wall_time(content(file_)), without_wall_time(content(whole_)));
  const SeriesProgress progress = series.progress();
  EXPECT_EQ(progress.done, mixed.size());
  EXPECT_EQ(progress.failed, 1);
}

TEST_F(Shards, GoOnWhereTheirFileEnds) {
  run_all(2);
  const std::string all = collected();
  const std::string complete = content(shard_file(1, 2));
  for (const std::size_t length : {std::size_t{0}, complete.size() / 2, complete.size() - 1}) {
    std::ofstream(shard_file(1, 2), std::ios::binary) << complete.substr(0, length);
    run({1, 2});
    EXPECT_EQ(without_wall_time(content(shard_file(1, 2))), without_wall_time(complete)) << length;
  }
  fs::remove(file_);
  EXPECT_EQ(collected(), all);
}

TEST_F(Shards, HaveOneWriterEach) {
  run_all(2);
  const OutputLock writer = OutputLock::of_file(shard_file(1, 2));
  EXPECT_INPUT_ERROR(run({1, 2}), "shard-1-of-2.csv: another process is writing to it");
  run({2, 2});
  EXPECT_EQ(series_.progress().done, small_scenes().size());
}

TEST_F(Shards, AreNotCollectedWhileRowsAreMissing) {
  expect_not_collected("has no shards");
  run({2, 3});
  expect_not_collected("4 of 6 runs are missing: shard 1/3 has 0 of 2, 3/3 has 0 of 2");
  run_all(3);
  fs::resize_file(shard_file(2, 3), fs::file_size(shard_file(2, 3)) - 1);
  expect_not_collected("1 of 6 runs are missing: shard 2/3 has 1 of 2");
}

TEST_F(Shards, AreNotDoubled) {
  run_all(2);
  EXPECT_INPUT_ERROR(run({1, 3}), "--shard: got 1/3, " + folder_ + " has shards of 2");
  fs::copy_file(shard_file(1, 2), shard_file(1, 3));
  EXPECT_INPUT_ERROR(collected(), "has runs doubled, in shard-1-of-2.csv, shard-1-of-3.csv: ");
  EXPECT_INPUT_ERROR(series_.progress(), "has runs doubled");
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(Shards, OfAnotherSeriesOrVersionAreRefused) {
  run_all(2);
  std::vector<Scene> others = small_scenes();
  for (Scene& scene : others) scene.material.k_b = 7.0;
  EXPECT_INPUT_ERROR(ShardedSeries(others, folder_).collect(file_),
                     "shard-1-of-2.csv:2: material.k_b: got 0.001, this series has 7");
  const std::string earlier =
      std::regex_replace(content(shard_file(1, 2)), std::regex("\n[0-9.]+,"), "\n0.1,");
  std::ofstream(shard_file(1, 2), std::ios::binary) << earlier;
  EXPECT_INPUT_ERROR(collected(), "shard-1-of-2.csv:2: version: got 0.1, this series has ");
  EXPECT_INPUT_ERROR(run({1, 2}), "shard-1-of-2.csv:2: version: got 0.1, this series has ");
  EXPECT_EQ(content(shard_file(1, 2)), earlier);
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(Shards, CompleteAFileOfTheSeriesAndLeaveOthersAlone) {
  run_all(2);
  const std::string all = undivided();
  fs::resize_file(whole_, content(whole_).find('\n') + 5);
  series_.collect(whole_);
  EXPECT_EQ(without_wall_time(content(whole_)), all);
  std::ofstream(file_, std::ios::binary) << "time,force\n";
  EXPECT_INPUT_ERROR(series_.collect(file_), "collected.csv:1: ");
  EXPECT_EQ(content(file_), "time,force\n");
}

TEST_F(Shards, TellHowFarTheyAre) {
  SeriesProgress progress = series_.progress();
  EXPECT_EQ(progress.count, 0);
  EXPECT_EQ(progress.done, 0);
  EXPECT_TRUE(progress.unfinished.empty());
  double forecast_of_all = 0.0;
  for (const Scene& scene : small_scenes()) forecast_of_all += forecast(scene).seconds;
  EXPECT_DOUBLE_EQ(progress.seconds_left, forecast_of_all);

  run({2, 3});
  progress = series_.progress();
  EXPECT_EQ(progress.count, 3);
  EXPECT_EQ(progress.runs, 6);
  EXPECT_EQ(progress.done, 2);
  ASSERT_EQ(progress.unfinished.size(), 2);
  EXPECT_EQ(text(progress.unfinished[1].shard), "3/3");
  EXPECT_EQ(progress.unfinished[1].runs, 2);
  EXPECT_GT(progress.unfinished[1].seconds_left, 0.0);
}

/// What is left is as much slower than its forecast as what is done.
TEST_F(Shards, KnowTheTimeLeftByTheTimeTaken) {
  run({1, 3});
  double taken = 0.0;
  for (const Row& row : series_.run({1, 3}, {})) taken += row.results.at("wall_time");
  EXPECT_NEAR(series_.progress().seconds_left, 2.0 * taken, 1e-6 * taken);
}

TEST_F(Shards, WithoutRunsWriteNothing) {
  run_all(4);
  EXPECT_FALSE(fs::exists(shard_file(4, 4)));
  EXPECT_EQ(collected(), undivided());
}

}  // namespace
}  // namespace impact
