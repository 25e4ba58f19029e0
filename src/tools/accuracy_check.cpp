// Random scenes, each with a wanted error, against a reference: how true the promised and the
// estimated errors are. A CSV row a scene, a summary on stdout.

#include <algorithm>
#include <array>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/asio/use_future.hpp>
#include <chrono>
#include <cmath>
#include <future>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "fits/statistics.hpp"
#include "output/interruption.hpp"
#include "output/output_lock.hpp"
#include "output/program.hpp"
#include "output/progress_bar.hpp"
#include "output/table.hpp"
#include "scene/scene_parameters.hpp"
#include "verification/accuracy.hpp"
#include "verification/random_scene.hpp"

namespace impact {
namespace {

constexpr std::chrono::milliseconds kPatience{100};

using Checks = std::vector<AccuracyCheck>;

using DrawScene = RandomScene (*)(std::uint64_t seed, int number);

AccuracyCheck check(DrawScene draw, std::uint64_t seed, int number) {
  const RandomScene random = draw(seed, number);
  return {random.scene, random.rejected, reference_answer(random.scene), try_scene(random.scene)};
}

/// All or, after an interruption, those that had begun, which are the first ones.
Checks check_all(DrawScene draw, std::uint64_t seed, int scenes, int jobs) {
  boost::asio::thread_pool pool(static_cast<std::size_t>(jobs));
  std::vector<std::future<std::optional<AccuracyCheck>>> futures;
  futures.reserve(static_cast<std::size_t>(scenes));
  for (int number = 0; number < scenes; ++number) {
    futures.push_back(boost::asio::post(
        pool, boost::asio::use_future([draw, seed, number]() -> std::optional<AccuracyCheck> {
          if (interrupted()) return std::nullopt;
          return check(draw, seed, number);
        })));
  }
  ProgressBar bar("accuracy_check", futures.size(), "scenes");
  Checks checks;
  checks.reserve(futures.size());
  for (auto& future : futures) {
    do {
      bar.show(checks.size());
    } while (future.wait_for(kPatience) != std::future_status::ready);
    if (auto done = future.get()) checks.push_back(*std::move(done));
  }
  return checks;
}

/// The keys that are drawn; those that a scene does not have are left empty.
const std::vector<std::string>& drawn_keys() {
  static const std::vector<std::string> keys{
      "seed",           "disk.points",      "disk.placement", "disk.rim",
      "material.k_a",   "material.k_b",     "material.eta",   "wall.a",
      "wall.V0",        "wall.points",      "wall.width",     "wall.height",
      "wall.threshold", "wall.gap_measure", "wall.boundary",  "wall.reset_interval",
      "load.P",         "impact.velocity",  "impact.gap",     "numerics.error"};
  return keys;
}

std::string value_of(const std::string& key, const Scene& scene) {
  const auto& table = scene_parameters();
  const auto parameter =
      std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.key == key; });
  return parameter->applies(scene) ? cell_text(parameter->write(scene)) : std::string();
}

Table table_of(const Checks& checks) {
  std::vector<std::string> columns{"number", "kind"};
  columns.insert(columns.end(), drawn_keys().begin(), drawn_keys().end());
  for (const char* column : {"status", "integrator", "step", "answer", "reference",
                             "reference_method", "reference_error", "estimated_error", "true_error",
                             "true_over_estimated", "verdict", "wall_time"}) {
    columns.emplace_back(column);
  }
  Table table(columns);
  for (std::size_t number = 0; number < checks.size(); ++number) {
    const AccuracyCheck& check = checks[number];
    table << static_cast<double>(number) << kind_of(check.scene);
    for (const std::string& key : drawn_keys()) table << value_of(key, check.scene);
    table << check.trial.status << check.trial.integrator << check.trial.step << check.trial.answer
          << check.reference.value << check.reference.method << check.reference.error
          << check.trial.estimated_error << check.true_error() << true_over_estimated(check)
          << name_of(verdict(check)) << check.trial.wall_time;
  }
  return table;
}

Checks of_kind(const Checks& checks, const std::string& kind) {
  Checks chosen;
  std::copy_if(checks.begin(), checks.end(), std::back_inserter(chosen),
               [&](const AccuracyCheck& check) { return kind_of(check.scene) == kind; });
  return chosen;
}

void print_row(const std::string& name, const Checks& checks) {
  std::map<Verdict, int> counts = count_verdicts(checks);
  const std::vector<double> errors = errors_over_wanted(checks);
  const int answered = static_cast<int>(checks.size()) - counts[Verdict::kRefused];
  fmt::print(
      "{:<15} {:>6}  {:>8} {:>6.1f} %  {:>5}  {:>6}  {:>9}  {:>12}  {:>8.2g} {:>8.2g} {:>8.2g}\n",
      name, checks.size(), answered, 100.0 * answered / static_cast<double>(checks.size()),
      counts[Verdict::kKept], counts[Verdict::kBroken], counts[Verdict::kUndefined],
      counts[Verdict::kNoReference], quantile(errors, 0.5), quantile(errors, 0.9),
      quantile(errors, 1.0));
}

void print_quality(const std::string& name, const Checks& checks) {
  const EstimateQuality quality = estimate_quality(checks);
  const auto known = static_cast<double>(quality.ratios.size());
  fmt::print("{:<15} {:>6}  {:>7}  {:>10.1f} %", name, quality.ratios.size(), quality.unknown,
             100.0 * quality.within / known);
  for (const double q : {0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99, 1.0}) {
    fmt::print("  {:>7.2g}", quantile(quality.ratios, q));
  }
  fmt::print("\n");
}

void print_by_kind(const Checks& checks, void (*print)(const std::string&, const Checks&)) {
  for (const char* kind : {"contact", "potential wall", "elastic wall"}) {
    const Checks chosen = of_kind(checks, kind);
    if (!chosen.empty()) print(kind, chosen);
  }
  print("all", checks);
}

void print_summary(const Checks& checks) {
  fmt::print(
      "kind            scenes  answered             kept  broken  undefined  no reference  true "
      "over wanted "
      "error: median, 90 %, greatest\n");
  print_by_kind(checks, &print_row);
  fmt::print(
      "\ntrue over estimated error; quantiles 1, 5, 25, 50, 75, 95, 99 and 100 %\n"
      "kind             known  unknown  within 100×\n");
  print_by_kind(checks, &print_quality);
  int rejected = 0;
  for (const AccuracyCheck& check : checks) rejected += check.rejected;
  fmt::print("\n{} scenes drawn besides are not of sensible size\n", rejected);
}

void print_refusals(const Checks& checks) {
  for (const auto& [cause, count] : count_refusals(checks)) fmt::print("{} × {}\n", count, cause);
}

/// Each with the command that repeats it.
void print_answers_in_doubt(const Checks& checks) {
  for (std::size_t number = 0; number < checks.size(); ++number) {
    const AccuracyCheck& check = checks[number];
    const Verdict said = verdict(check);
    if (said != Verdict::kBroken && said != Verdict::kUndefined) continue;
    fmt::print(
        "scene {}, {}: {:.10g}, reference {:.10g} to {:.1g}, true error {:.2g} ({:.2g} of the "
        "wanted), estimated {:.2g}\n  {}\n",
        number, name_of(said), check.trial.answer, check.reference.value, check.reference.error,
        check.true_error(), check.true_error() / check.scene.numerics.error,
        check.trial.estimated_error, impact_command(check.scene));
  }
}

void check_accuracy(DrawScene draw, std::uint64_t seed, int scenes, int jobs,
                    const std::string& output) {
  const OutputLock lock = OutputLock::of_file(output);
  take_interruptions();
  const Checks checks = check_all(draw, seed, scenes, jobs);
  table_of(checks).write(output);
  print_summary(checks);
  print_refusals(checks);
  print_answers_in_doubt(checks);
  if (interrupted()) throw std::runtime_error("interrupted");
  if (const int broken = count_verdicts(checks)[Verdict::kBroken]; broken > 0) {
    throw std::runtime_error(fmt::format("{} answers err by more than was asked for", broken));
  }
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  CLI::App app("Compares the errors of random scenes with those that were asked for.",
               "accuracy_check");
  std::string output;
  int scenes = 50;
  std::uint64_t seed = 1;
  bool slow = false;
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  app.add_option("--output", output, "CSV file")->required();
  app.add_option("--scenes", scenes, "how many")
      ->capture_default_str()
      ->check(CLI::Range(1, 10000));
  app.add_option("--seed", seed, "of the random scenes")->capture_default_str();
  app.add_flag("--slow", slow,
               "slow impacts, of which auto tries the methods reduced, modal and imex");
  app.add_option("--jobs", jobs, "threads")->capture_default_str()->check(CLI::Range(1, 1024));
  return impact::run_tool(app, argc, argv, [&] {
    impact::check_accuracy(slow ? impact::random_slow_scene : impact::random_scene, seed, scenes,
                           jobs, output);
  });
}
