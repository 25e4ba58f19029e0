#include "series/series.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <regex>
#include <set>
#include <utility>

#include "expect_input_error.hpp"
#include "kernels/threads.hpp"
#include "mechanics/lane_field.hpp"
#include "run/compose.hpp"
#include "scene/scene_parameters.hpp"
#include "series/convergence_study.hpp"
#include "series/side_by_side.hpp"
#include "small_scenes.hpp"

namespace impact {
namespace {

constexpr int kRuns = 6;

class RunSeries : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::remove(path_); }
  std::vector<Row> run(const std::vector<Scene>& scenes, int jobs = 2) const {
    return run_series(scenes, path_, {jobs});
  }
  std::string path_ = testing::TempDir() + "series.csv";
};

/// Before the others have run.
TEST_F(RunSeries, RefusesWhatTakesTooLong) {
  EXPECT_INPUT_ERROR(run(scenes("{scene: collision, disk: {points: [40, 41]}, "
                                "impact: {gap: 100, velocity: [0.5, 1e-9]}, "
                                "numerics: {integrator: verlet}}")),
                     "numerics.longest: this scene would take about ");
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(RunSeries, WritesTheSameBytesForAnyNumberOfThreads) {
  run(small_scenes(), 1);
  const std::string of_one = content(path_);
  std::filesystem::remove(path_);
  run(small_scenes(), 3);
  EXPECT_EQ(without_wall_time(content(path_)), without_wall_time(of_one));
  EXPECT_EQ(std::count(of_one.begin(), of_one.end(), '\n'), 1 + kRuns);
}

TEST_F(RunSeries, GivesTheResultsOfTheSingleStudies) {
  const auto rows = run(small_scenes());
  ASSERT_EQ(rows.size(), kRuns);
  for (const Row& row : rows) {
    ConvergenceStudy study(row.scene);
    while (!study.finished()) study.advance();
    EXPECT_EQ(row.results.at("restitution"), study.impact().value.restitution);
    EXPECT_EQ(row.results.at("steps"), study.run().state().step);
    EXPECT_TRUE(std::isnan(row.results.at("integrator")));
    EXPECT_EQ(row.flags.empty(), study.run().flags().empty());
  }
  EXPECT_EQ(to_yaml(rows[4].scene), to_yaml(small_scenes()[4]));
}

TEST_F(RunSeries, GoesOnWhereTheFileEnds) {
  const auto rows = run(small_scenes());
  const std::string complete = content(path_);
  for (const std::size_t length : {std::size_t{0}, std::size_t{10}, complete.find('\n') + 1,
                                   complete.size() / 2, complete.size() - 1, complete.size()}) {
    std::filesystem::resize_file(path_, length);
    const std::size_t kept = content(path_).rfind('\n') + 1;
    const auto again = run(small_scenes());
    const std::string mended = content(path_);
    EXPECT_EQ(without_wall_time(mended), without_wall_time(complete)) << length;
    EXPECT_EQ(mended.substr(0, kept), complete.substr(0, kept)) << length;
    ASSERT_EQ(again.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_EQ(again[i].results.at("restitution"), rows[i].results.at("restitution"));
      EXPECT_EQ(again[i].flags, rows[i].flags);
    }
    std::ofstream(path_, std::ios::binary) << complete;
  }
}

TEST_F(RunSeries, LeavesAForeignFileAlone) {
  run(small_scenes());
  const std::string of_series = content(path_);
  std::vector<Scene> others = small_scenes();
  others[2].material.k_a = 7.0;
  const std::vector<Scene> fewer(others.begin(), others.begin() + 2);
  EXPECT_INPUT_ERROR(run(others), "series.csv:4: material.k_a: got 1, this series has 7");
  EXPECT_INPUT_ERROR(run(fewer), "series.csv:4: this series has 2 runs only");
  EXPECT_EQ(content(path_), of_series);
  for (const std::string foreign : {"time,force\n0,1\n", "no table", "\n", "\"\\x\"\n"}) {
    std::ofstream(path_, std::ios::binary) << foreign;
    EXPECT_INPUT_ERROR(run(others), "series.csv:1: ");
    EXPECT_EQ(content(path_), foreign);
  }
}

TEST_F(RunSeries, ReadsBackAnyText) {
  {
    SeriesFile file(path_, small_scenes());
    file.open();
    file.append(failure("a \"reason\",\nwith \\ in it"));
  }
  const auto rows = run(small_scenes());
  EXPECT_TRUE(has_failed(rows[0]));
  EXPECT_EQ(rows[0].flags, "failed: a \"reason\",\nwith \\ in it");
  EXPECT_TRUE(std::isnan(rows[0].results.at("restitution")));
  EXPECT_FALSE(has_failed(rows[1]));
}

TEST_F(RunSeries, HasOneWriterAFile) {
  run(small_scenes());
  const std::string of_series = content(path_);
  const SeriesFile other(path_, small_scenes());
  EXPECT_INPUT_ERROR(run(small_scenes()), "series.csv: another process is writing to it");
  EXPECT_EQ(content(path_), of_series);
}

/// A disk that starts deep in the wall.
TEST_F(RunSeries, GoesOnAfterARunThatFailed) {
  const auto rows =
      run(scenes("{scene: collision, disk: {points: 40}, impact: {gap: [-1, auto]}}"), 1);
  EXPECT_TRUE(has_failed(rows[0])) << rows[0].flags;
  EXPECT_TRUE(std::isnan(rows[0].results.at("restitution")));
  EXPECT_FALSE(has_failed(rows[1]));
  EXPECT_GT(rows[1].results.at("restitution"), 0.0);
}

/// Of the 31 points of the rectangle 24 are on its rim.
TEST_F(RunSeries, SaysThatTheMiddleOfARectangleIsEmpty) {
  const auto rows = run(scenes("{scene: stretch, stretch: {width: 0.3, height: 0.3}}"));
  EXPECT_EQ(rows[0].flags,
            "failed: the middle of the rectangle has too few points for a mean strain");
}

TEST_F(RunSeries, LeavesEmptyWhatASceneDoesNotHave) {
  const auto rows = run(scenes(
      "{scene: contact, disk: {points: 40}, numerics: {integrator: newton}, load: {hold_rotation: "
      "[false, true]}}"));
  EXPECT_TRUE(std::isnan(rows[0].results.at("hold_torque")));
  EXPECT_TRUE(std::isfinite(rows[1].results.at("hold_torque")));
  EXPECT_GT(rows[0].results.at("strain"), 0.0);
}

TEST_F(RunSeries, CreatesNothingForAFirstSceneThatCannotBeComposed) {
  EXPECT_INPUT_ERROR(run(scenes("{scene: collision, disk: {file: /nowhere}}")), "disk.file");
  EXPECT_FALSE(std::filesystem::exists(path_));
}

/// Impacts on one lattice that need different integrators, one of which lanes do not take, several
/// runs, or halved steps (v = 0.4 c on the hard wall).
std::vector<Scene> impacts_on_the_potential_wall() {
  return scenes(
      "{scene: collision, disk: {points: 20}, impact: {velocity: [0.02, 0.025, 0.03, 0.04, 0.05, "
      "0.4]},"
      " material: {eta: [0, 1, 100]}, wall: {a: [300, 1000]}, numerics: {error: [1.e-3, 1.e-6]}}");
}

/// All boundaries and gap measures without damping.
std::vector<Scene> impacts_on_the_elastic_wall() {
  std::vector<Scene> all;
  for (const char* const wall :
       {"reset_interval: [0.004, 0.016]", "boundary: fixed", "gap_measure: vertical"}) {
    for (const Scene& scene :
         scenes(fmt::format("{{scene: collision, disk: {{points: 40}}, wall: {{type: lattice, "
                            "points: 50, {}}}, impact: {{velocity: [0.02, 0.03, 0.04, 0.05]}}}}",
                            wall))) {
      all.push_back(scene);
    }
  }
  return all;
}

/// Loads up to crushing (the first folds, with many steps and shifts, while others finish), with
/// and without the rotation held.
std::vector<Scene> contacts() {
  return scenes(
      "{scene: contact, disk: {points: 300}, load: {P: [0.4, 1.e-4, 2.e-4, 0.003, 0.005, 0.02, "
      "0.1],"
      " hold_rotation: [true, false]}, material: {k_b: [0, 5]}}");
}

std::vector<Scene> stretches() {
  return scenes(
      "{scene: stretch, disk: {points: 300}, stretch: {strain: [1.e-4, 1.e-3, 0.01, 0.03]}}");
}

std::string yaml_without_wall_time(const Result& result) {
  YAML::Node map = to_yaml(result);
  map.remove("wall_time");
  return YAML::Dump(map);
}

/// To the last bit. Returns the integrators that were used.
std::set<std::string> expect_results_of_single_studies(const std::vector<Scene>& scenes) {
  std::set<std::string> integrators;
  EXPECT_TRUE(std::all_of(scenes.begin(), scenes.end(), may_be_in_lanes));
  const auto outcome = simulate_side_by_side(
      scenes, make_common_bodies(scenes), [] { return false; }, [] {});
  EXPECT_TRUE(outcome->in_lanes);
  EXPECT_EQ(outcome->results.size(), scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    SCOPED_TRACE(i);
    ConvergenceStudy study(scenes[i]);
    while (!study.finished()) study.advance();
    const Result& result = outcome->results[i];
    integrators.insert(std::get<std::string>(*result.find("integrator")));
    EXPECT_EQ(yaml_without_wall_time(result), yaml_without_wall_time(study.result()));
  }
  return integrators;
}

TEST(SideBySide, GivesTheResultsOfSingleStudiesToTheLastBit) {
  EXPECT_EQ(expect_results_of_single_studies(impacts_on_the_potential_wall()),
            (std::set<std::string>{"verlet", "takahashi_imada", "imex", "extrapolated_damping"}));
}

/// The scenes of one lattice share its modes.
TEST(SideBySide, DoesSoWithSlowImpactsInModes) {
  const auto list = scenes(
      "{scene: collision, disk: {points: 1099}, material: {eta: [10, 30]}, impact: {velocity: "
      "[0.002, 0.004]}}");
  const auto outcome = simulate_side_by_side(
      list, make_common_bodies(list), [] { return false; }, [] {});
  ASSERT_EQ(outcome->results.size(), list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    ConvergenceStudy study(list[i]);
    while (!study.finished()) study.advance();
    EXPECT_EQ(std::get<std::string>(*study.result().find("integrator")), "modal");
    EXPECT_EQ(yaml_without_wall_time(outcome->results[i]), yaml_without_wall_time(study.result()));
  }
}

TEST(SideBySide, DoesSoOnTheElasticWall) {
  expect_results_of_single_studies(impacts_on_the_elastic_wall());
}

TEST(SideBySide, DoesSoWhereTheDiskSlides) {
  expect_results_of_single_studies(
      scenes("{scene: collision, disk: {points: 20, orientation: balanced}, impact: "
             "{velocity: [0.03, 0.05], angle: [-30, 60], spin: [0, 0.02]}}"));
}

TEST(SideBySide, DoesSoWithARowOfDisks) {
  expect_results_of_single_studies(
      scenes("{scene: collision, disk: {points: 20}, wall: {type: disk, disks: 3, mirrored: true, "
             "a: [150, "
             "300]}, impact: {velocity: [0.03, 0.05], angle: [0, 20]}}"));
}

TEST(SideBySide, DoesSoWithTwoDisks) {
  expect_results_of_single_studies(scenes(
      "{scene: collision, disk: {points: 30}, wall: {type: disk, radius: 0.8, a: [150, 300]}, "
      "impact: {velocity: [0.03, 0.05], angle: [0, 40]}}"));
}

TEST(SideBySide, DoesSoWithDampedDisks) {
  const auto integrators = expect_results_of_single_studies(
      scenes("{scene: collision, disk: {points: 30}, material: {eta: [0.3, 300]}, wall: {type: "
             "disk, disks: 2}, impact: {velocity: [0.02, 0.03, 0.04, 0.05]}}"));
  EXPECT_EQ(integrators, (std::set<std::string>{"verlet", "implicit_damping"}));
}

/// On one processor or on all.
TEST(ConvergenceStudy, GivesTheSameBitsOnSeveralProcessors) {
  const auto result = [](int threads) {
    const int before = std::exchange(threads_in_a_run(), threads);
    ConvergenceStudy study(
        scenes("{scene: collision, disk: {points: 40}, impact: {velocity: 0.05}, numerics: {error: "
               "1.e-7}}")
            .front());
    while (!study.finished()) study.advance();
    threads_in_a_run() = before;
    return yaml_without_wall_time(study.result());
  };
  EXPECT_EQ(result(1), result(0));
}

/// What lanes take by its forces is put to them by its scene.
TEST(SideBySide, PutsIntoLanesWhatLanesKnow) {
  const auto scenes_with = {"wall: {type: potential}",
                            "wall: {type: lattice, points: 60, boundary: fixed}",
                            "wall: {type: lattice, points: 60, boundary: viscous}",
                            "wall: {type: lattice, points: 60, k_a: 0.5}",
                            "wall: {type: lattice, points: 60, eta: 1}",
                            "wall: {type: disk}",
                            "wall: {type: disk, disks: 2}",
                            "wall: {type: disk, radius: 0.5, k_a: 2}"};
  for (const char* const with : scenes_with) {
    for (const Scene& scene : scenes(fmt::format(
             "{{scene: collision, disk: {{points: 20}}, material: {{eta: [0, 1]}}, {}}}", with))) {
      EXPECT_EQ(may_be_in_lanes(scene), LaneField::knows(compose(scene).field)) << with;
    }
  }
}

/// Scenes with a term that lanes do not know go one by one, beside others that they know.
TEST(SideBySide, LeavesOutWhatLanesDoNotKnow) {
  const auto falling = scenes(
      "{scene: collision, disk: {points: 20}, gravity: [0, 1.0e-3], seed: 1, "
      "impact: {velocity: [0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08, 0.09]}}");
  EXPECT_FALSE(LaneField::knows(compose(falling.back()).field));
  expect_results_of_single_studies(falling);
  const auto all_fall = scenes(
      "{scene: collision, disk: {points: 20}, gravity: 1.0e-3, "
      "impact: {velocity: [0.02, 0.03, 0.04, 0.05]}}");
  const auto outcome = simulate_side_by_side(
      all_fall, make_common_bodies(all_fall), [] { return false; }, [] {});
  EXPECT_FALSE(outcome->in_lanes);
  EXPECT_EQ(outcome->results.size(), all_fall.size());
}

TEST(SideBySide, DoesSoWithStaticSolutions) {
  expect_results_of_single_studies(contacts());
  expect_results_of_single_studies(stretches());
}

/// One that starts deep in the wall.
TEST(SideBySide, OthersGoOnWhenARunFails) {
  std::vector<Scene> scenes(12, impacts_on_the_potential_wall().front());
  scenes[5].impact.gap = -1.0;
  std::size_t done = 0;
  const auto outcome = simulate_side_by_side(
      scenes, make_common_bodies(scenes), [] { return false; }, [&] { ++done; });
  EXPECT_TRUE(outcome->in_lanes);
  EXPECT_EQ(done, scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const std::vector<std::string> flags = outcome->results[i].flags();
    const bool failed = !flags.empty() && flags[0].rfind("failed: ", 0) == 0;
    EXPECT_EQ(failed, i == 5);
  }
}

TEST(SideBySide, StopsWhenTold) {
  const std::vector<Scene> scenes = impacts_on_the_potential_wall();
  EXPECT_FALSE(simulate_side_by_side(
                   scenes, make_common_bodies(scenes), [] { return true; }, [] {})
                   .has_value());
}

TEST_F(RunSeries, InLanesWritesTheSameBytesForAnyNumberOfThreads) {
  const std::vector<Scene> scenes = impacts_on_the_potential_wall();
  run(scenes, 1);
  const std::string of_one = content(path_);
  std::filesystem::remove(path_);
  run(scenes, 5);
  EXPECT_EQ(without_wall_time(content(path_)), without_wall_time(of_one));
}

/// Three impacts do not fill the lanes, and yet those of the next disk do not join them.
TEST_F(RunSeries, KeepsDisksApartInLanes) {
  const auto rows = run(scenes("{scene: collision, disk: {points: 20}, seed: [1, 2], "
                               "impact: {velocity: [0.03, 0.04, 0.05]}}"),
                        1);
  ASSERT_EQ(rows.size(), 6);
  for (const Row& row : rows) {
    EXPECT_TRUE(may_be_in_lanes(row.scene));
    ConvergenceStudy study(row.scene);
    while (!study.finished()) study.advance();
    EXPECT_EQ(row.results.at("restitution"), study.impact().value.restitution);
  }
}

TEST_F(RunSeries, StopsAtTheFirstSceneThatCannotBeComposed) {
  EXPECT_INPUT_ERROR(
      run(scenes("{scene: collision, disk: {points: 40}, numerics: {step: [auto, 9, 8]}}")),
      "numerics.step: got 9");
  const std::string csv = content(path_);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2) << csv;
}

TEST_F(RunSeries, BreaksOffBetweenRows) {
  SeriesOptions options;
  std::atomic<bool> stop{false};
  options.progress = [&](std::size_t rows, std::size_t /*runs*/) { stop = rows == 3; };
  options.stop = [&stop] { return stop.load(); };
  EXPECT_THROW(run_series(small_scenes(), path_, options), std::runtime_error);
  const std::string csv = content(path_);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3);
  EXPECT_EQ(csv.back(), '\n');
  EXPECT_EQ(run(small_scenes()).size(), kRuns);
}

}  // namespace
}  // namespace impact
