#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <thread>
#include <utility>

#include "fits/statistics.hpp"
#include "output/progress_bar.hpp"
#include "output/table.hpp"
#include "scene/scene_parameters.hpp"
#include "verification/work_precision.hpp"

namespace impact {
namespace {

/// An error, and what `auto` is compared with at this viscosity.
struct Comparison {
  double error;
  double eta;
  std::vector<IntegratorKind> others;
};

std::vector<Comparison> comparisons() {
  return {{1e-9, 0.0, {IntegratorKind::kRk8pd, IntegratorKind::kVerlet}},
          {1e-6, 100.0, {IntegratorKind::kRk8pd}}};
}

/// `quick`: of one speed and a small lattice.
std::vector<Scene> scenes_of(const Comparison& comparison, bool quick) {
  constexpr int kLattices = 3;
  constexpr double kNoOutput = 1e6;  // R/c
  std::vector<Scene> scenes;
  for (const double velocity : {0.01, 0.02, 0.05}) {
    for (int seed = 1; seed <= kLattices; ++seed) {
      Scene scene;
      scene.seed = static_cast<std::uint64_t>(seed);
      scene.impact.velocity = velocity;
      scene.material.eta = comparison.eta;
      scene.numerics.error = comparison.error;
      scene.output.period = kNoOutput;
      scenes.push_back(scene);
    }
  }
  if (quick) scenes = {scenes.back()};
  if (quick) scenes[0].disk.recipe.points = 60;
  return scenes;
}

/// e by a method of order 6 in short steps.
double reference_of(Scene scene) {
  constexpr double kShorter = 8.0;
  scene.numerics.integrator = most_exact(scene);
  scene.numerics.step = longest_step(scene, scene.numerics.integrator) / kShorter;
  return outcome_of(scene, Until::kAnswer).answer;
}

/// The scene with the step or tolerance of this integrator that just keeps the wanted error: found
/// by the true error, which falls as h² or as the tolerance. Nothing when it is not found.
std::optional<Scene> with_known_setting(Scene scene, IntegratorKind integrator, double answer) {
  constexpr double kFirstTolerance = 1e-3;
  constexpr double kLeastTolerance = 1e-14;
  constexpr int kMostTries = 12;
  const bool adaptive = is_adaptive(integrator);
  scene.numerics.integrator = integrator;
  double setting = adaptive ? kFirstTolerance : longest_step(scene, integrator);
  for (int attempt = 0; attempt < kMostTries; ++attempt) {
    throw_if_interrupted();
    (adaptive ? scene.numerics.tolerance : scene.numerics.step) = setting;
    const double error = std::abs(outcome_of(scene, Until::kAnswer).answer / answer - 1.0);
    if (error <= scene.numerics.error) return scene;
    const double excess = error / scene.numerics.error;
    setting /= adaptive ? std::clamp(excess, 2.0, 1e3) : std::clamp(std::sqrt(excess), 1.05, 32.0);
    if (adaptive) setting = std::max(setting, kLeastTolerance);
  }
  return {};
}

/// The timed runs of one scene: `auto` first.
std::vector<TimedScene> timed_scenes_of(const Scene& scene, const Comparison& comparison,
                                        double answer) {
  std::vector<TimedScene> list{{scene, Until::kAnswer}};
  for (const IntegratorKind other : comparison.others) {
    Scene verified = scene;
    verified.numerics.integrator = other;
    list.emplace_back(verified, Until::kAnswer);
    const std::optional<Scene> bare = with_known_setting(scene, other, answer);
    if (bare) list.emplace_back(*bare, Until::kAnswer);
  }
  return list;
}

std::string name_of(const TimedScene& one) {
  return fmt::format("{} {}", one.is_verified() ? "verified" : "bare",
                     impact::name_of(one.scene().numerics.integrator));
}

void compare(const Comparison& comparison, const WorkPrecision& task, Table& table) {
  std::map<std::string, std::vector<double>> ratios;
  const std::vector<Scene> scenes = scenes_of(comparison, task.quick);
  ProgressBar bar(fmt::format("work_precision: error {:.0e}", comparison.error), scenes.size(),
                  "scenes");
  std::size_t done = 0;
  for (const Scene& scene : scenes) {
    bar.show(done++);
    const double answer = reference_of(scene);
    std::vector<TimedScene> list = timed_scenes_of(scene, comparison, answer);
    for (TimedScene& one : list) one.run(std::numeric_limits<double>::infinity());
    repeat_in_turn(list, task.effort);
    for (const TimedScene& one : list) {
      const double ratio = list.front().median_time() / one.median_time();
      table << comparison.error << comparison.eta << scene.impact.velocity
            << static_cast<double>(scene.seed) << name_of(one)
            << impact::name_of(one.outcome().integrator) << one.outcome().step
            << one.scene().numerics.tolerance.value_or(Outcome::kNaN)
            << static_cast<double>(one.runs()) << one.median_time()
            << std::abs(one.outcome().answer / answer - 1.0) << ratio;
      ratios[name_of(one)].push_back(ratio);
    }
  }
  bar.clear();
  for (const auto& [name, values] : ratios) {
    if (name == "verified auto") continue;
    fmt::print("error {:.0e}, eta* = {}: auto takes {:.3f} of the time of {} ({:.3f} ... {:.3f})\n",
               comparison.error, comparison.eta, median(values), name,
               *std::min_element(values.begin(), values.end()),
               *std::max_element(values.begin(), values.end()));
  }
}

}  // namespace

void compare_times(const WorkPrecision& task) {
  Table table({"wanted_error", "eta", "velocity", "seed", "case", "chosen", "step", "tolerance",
               "repeats", "time", "error", "time_of_auto_by_this"});
  fmt::print("\nTimes, medians over 0.01, 0.02, 0.05 c and three lattices (least ... greatest)\n");
  for (const Comparison& comparison : comparisons()) compare(comparison, task, table);
  table.write(task.folder / "timing.csv");
}

std::string machine() {
  std::ifstream file("/proc/cpuinfo");
  std::string model = "unknown processor";
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) != 0 || colon == std::string::npos) continue;
    model = line.substr(colon + 2);
    break;
  }
  return fmt::format("{}, {} cores", model, std::thread::hardware_concurrency());
}

}  // namespace impact
