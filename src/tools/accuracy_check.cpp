// Random scenes, each with several wanted errors, against a reference: how true the promised errors
// are. A CSV row a scene and error, a summary on stdout.

#include <algorithm>
#include <array>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/asio/use_future.hpp>
#include <cmath>
#include <fstream>
#include <future>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "lattice/input_error.hpp"
#include "tools/accuracy.hpp"
#include "tools/program.hpp"
#include "tools/progress_bar.hpp"
#include "tools/reference_integrator.hpp"
#include "tools/table.hpp"

namespace impact {
namespace {

struct SceneCheck {
  Scene scene;
  ReferenceAnswer reference;
  std::vector<AccuracyTrial> trials;
};

SceneCheck check(std::uint64_t seed, int number) {
  const Scene scene = random_scene(seed, number);
  SceneCheck check{scene, reference_answer(scene), {}};
  for (const double error : asked_errors(scene)) {
    check.trials.push_back(try_accuracy(scene, error, check.reference));
  }
  return check;
}

std::vector<SceneCheck> check_all(std::uint64_t seed, int scenes, int jobs) {
  boost::asio::thread_pool pool(static_cast<std::size_t>(jobs));
  std::vector<std::future<SceneCheck>> futures;
  futures.reserve(static_cast<std::size_t>(scenes));
  for (int number = 0; number < scenes; ++number) {
    futures.push_back(boost::asio::post(
        pool, boost::asio::use_future([seed, number] { return check(seed, number); })));
  }
  ProgressBar bar(futures.size());
  std::vector<SceneCheck> checks;
  checks.reserve(futures.size());
  for (auto& future : futures) {
    bar.show(checks.size());
    checks.push_back(future.get());
  }
  return checks;
}

std::string without_commas(std::string text) {
  std::replace(text.begin(), text.end(), ',', ';');
  return text;
}

std::string kind_of(const Scene& scene) {
  if (scene.kind == SceneKind::kContact) return "contact";
  return scene.wall.kind == WallKind::kLattice ? "elastic wall" : "potential wall";
}

/// The parameters that the scene has; of others an empty cell.
void add_parameters(const Scene& scene, Table& table) {
  const bool contact = scene.kind == SceneKind::kContact;
  const bool elastic = kind_of(scene) == "elastic wall";
  const auto number = [&](bool has, double value) {
    table << (has ? fmt::format("{}", value) : std::string());
  };
  number(true, static_cast<double>(scene.seed));
  number(true, scene.disk.recipe.points);
  table << std::string(scene.disk.recipe.placement == Placement::kUniform ? "uniform"
                                                                          : "blue_noise");
  number(true, scene.material.k_b);
  number(!contact, scene.material.eta);
  number(true, scene.wall.a);
  number(!contact, scene.impact.velocity);
  number(contact, scene.load.p);
  const std::map<Boundary, std::string> boundaries{
      {Boundary::kReset, "reset"}, {Boundary::kFixed, "fixed"}, {Boundary::kViscous, "viscous"}};
  table << (elastic ? boundaries.at(scene.wall.boundary) : std::string());
  table << std::string(!elastic                                ? ""
                       : scene.wall.gap == GapMeasure::kNormal ? "normal"
                                                               : "vertical");
}

Table table_of(const std::vector<SceneCheck>& checks) {
  Table table({"number",     "kind",     "seed",        "points",          "placement",
               "k_b",        "eta",      "a",           "velocity",        "P",
               "boundary",   "gap",      "asked_error", "status",          "integrator",
               "step",       "answer",   "reference",   "reference_error", "estimated_error",
               "true_error", "wall_time"});
  for (std::size_t number = 0; number < checks.size(); ++number) {
    const auto& [scene, reference, trials] = checks[number];
    for (const AccuracyTrial& trial : trials) {
      table << static_cast<double>(number) << kind_of(scene);
      add_parameters(scene, table);
      table << trial.asked_error << without_commas(trial.status) << trial.integrator << trial.step
            << trial.answer << reference.value << reference.error << trial.estimated_error
            << trial.true_error << trial.wall_time;
    }
  }
  return table;
}

double quantile(const std::vector<double>& sorted, double q) {
  return sorted[static_cast<std::size_t>(std::lround(q * static_cast<double>(sorted.size() - 1)))];
}

/// Of the answers to the n-th error of all scenes.
struct Summary {
  int answered = 0;
  /// True over asked error, rising, where the reference is good to a hundredth of the error.
  std::vector<double> ratios;
};

Summary summary_of(const std::vector<SceneCheck>& checks, std::size_t n) {
  Summary summary;
  for (const auto& [scene, reference, trials] : checks) {
    const AccuracyTrial& trial = trials[n];
    if (trial.status != "answered") continue;
    ++summary.answered;
    if (!(reference.error <= 0.01 * trial.asked_error)) continue;
    summary.ratios.push_back(trial.true_error / trial.asked_error);
  }
  std::sort(summary.ratios.begin(), summary.ratios.end());
  return summary;
}

bool breaks_promise(const AccuracyTrial& trial) { return trial.true_error > trial.asked_error; }

void print_summary(const std::vector<SceneCheck>& checks) {
  fmt::print(
      "asked error (elastic wall)  answered  with reference  true/asked: median  90 %  max\n");
  constexpr std::array<const char*, 3> kNames{"1e-3 (1e-2)", "1e-5 (1e-3)", "1e-7 (1e-4)"};
  for (std::size_t n = 0; n < kNames.size(); ++n) {
    const Summary summary = summary_of(checks, n);
    fmt::print("{:<26}  {:>4}/{:<3}  {:>14}", kNames[n], summary.answered, checks.size(),
               summary.ratios.size());
    if (!summary.ratios.empty()) {
      fmt::print("  {:>18.2g}  {:.2g}  {:.2g}", quantile(summary.ratios, 0.5),
                 quantile(summary.ratios, 0.9), summary.ratios.back());
    }
    fmt::print("\n");
  }
}

void print_failures(const std::vector<SceneCheck>& checks) {
  for (std::size_t number = 0; number < checks.size(); ++number) {
    const auto& [scene, reference, trials] = checks[number];
    if (!reference.failure.empty()) {
      fmt::print("scene {} has no reference: {}\n", number, reference.failure);
    }
    for (const AccuracyTrial& trial : trials) {
      if (trial.status != "answered") fmt::print("scene {}: {}\n", number, trial.status);
      if (breaks_promise(trial)) {
        fmt::print("scene {}: asked for {:g}, true error {:.2g}, reference to {:.1g}\n", number,
                   trial.asked_error, trial.true_error, reference.error);
      }
    }
  }
}

void check_accuracy(std::uint64_t seed, int scenes, int jobs, const std::string& output) {
  if (!std::ofstream(output, std::ios::app)) {
    throw InputError(fmt::format("--output: {} cannot be written", output));
  }
  const std::vector<SceneCheck> checks = check_all(seed, scenes, jobs);
  table_of(checks).write(output);
  print_summary(checks);
  print_failures(checks);
  std::ptrdiff_t broken = 0;
  for (const SceneCheck& check : checks) {
    broken += std::count_if(check.trials.begin(), check.trials.end(), breaks_promise);
  }
  if (broken > 0) {
    throw std::runtime_error(fmt::format("{} answers err by more than was asked for", broken));
  }
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  impact::offer_reference_integrator();
  CLI::App app("Compares the errors of random scenes with those that were asked for.",
               "accuracy_check");
  std::string output;
  int scenes = 50;
  std::uint64_t seed = 1;
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  app.add_option("--output", output, "CSV file")->required();
  app.add_option("--scenes", scenes, "how many")
      ->capture_default_str()
      ->check(CLI::Range(1, 10000));
  app.add_option("--seed", seed, "of the random scenes")->capture_default_str();
  app.add_option("--jobs", jobs, "threads")->capture_default_str()->check(CLI::Range(1, 1024));
  return impact::run_tool(app, argc, argv,
                          [&] { impact::check_accuracy(seed, scenes, jobs, output); });
}
