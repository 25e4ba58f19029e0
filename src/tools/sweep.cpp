// Many runs of a scene on all processors: a CSV row a run, a table of the main results on stdout.

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include "output/interruption.hpp"
#include "output/program.hpp"
#include "output/progress_bar.hpp"
#include "run/forecast.hpp"
#include "scene/keys.hpp"
#include "scene/scene_files.hpp"
#include "series/series.hpp"
#include "series/summary.hpp"
#include "series/sweep_values.hpp"
#include "tools/sharding.hpp"

namespace impact {
namespace {

struct SweepOptions {
  std::string scene_file;
  std::vector<std::string> assignments;
  std::string output;
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  Sharding sharding;
};

void tell_if_long(const std::vector<Scene>& scenes) {
  Forecast all;
  for (const Scene& scene : scenes) {
    const Forecast expected = forecast(scene);
    if (expected.seconds > scene.numerics.longest) return;  // refused before anything runs
    all.steps += expected.steps;
    all.seconds += expected.seconds;
  }
  if (all.seconds <= kWorthTelling) return;
  fmt::print(stderr, "sweep: these scenes will take at most about {}\n", text(all));
}

void fail_if_runs_failed(const std::vector<Row>& rows, const std::string& file) {
  const auto failed = std::count_if(rows.begin(), rows.end(), has_failed);
  if (failed == 0) return;
  throw std::runtime_error(
      fmt::format("{} of {} runs failed: see flags in {}", failed, rows.size(), file));
}

void tell_results(const std::vector<Row>& rows, const std::string& file) {
  fmt::print("{}", summary(rows));
  fail_if_runs_failed(rows, file);
}

void simulate(const std::vector<Scene>& scenes, const SweepOptions& options) {
  tell_if_long(scenes);
  take_interruptions();
  std::vector<Row> rows;
  {
    ProgressBar bar("sweep", scenes.size());
    rows = run_series(scenes, options.output, watched(options.jobs, bar));
  }
  tell_results(rows, options.output);
}

/// The file, which is the last word of the command line.
std::string take_file(std::vector<std::string>& words) {
  if (words.empty() || words.back().find('=') != std::string::npos) {
    throw InputError("--collect: FILE.csv is missing, the last word of the command line");
  }
  std::string file = std::move(words.back());
  words.pop_back();
  return file;
}

void sweep(SweepOptions& options) {
  const Sharding& sharding = options.sharding;
  const std::string file = sharding.collect ? take_file(options.assignments) : "";
  const std::vector<Scene> scenes =
      parse_sweep(load_keys(scene_path(options.scene_file)), options.assignments);
  const ShardedSeries shards(scenes, options.output);
  if (sharding.status) {
    print_status(shards, sharding.format);
  } else if (sharding.collect) {
    tell_results(shards.collect(file), file);
  } else if (!sharding.shard.empty()) {
    const Shard shard = parse_shard(sharding.shard);
    fail_if_runs_failed(simulate_shard("sweep", shards, shard, options.jobs),
                        shards.file_of(shard).string());
  } else {
    simulate(scenes, options);
  }
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  CLI::App app("Simulates a scene for all combinations of values; a row of a CSV file a run.",
               "sweep");
  impact::SweepOptions options;
  app.add_option("scene", options.scene_file,
                 "collision, contact, absorbing_wall, stretch, or a scene file")
      ->required();
  app.add_option("assignments", options.assignments,
                 "key=v1,v2,... or key=lo:hi:n or key=lo:hi:n:log; with --collect, last of all, "
                 "the CSV file");
  app.add_option("--output", options.output,
                 "CSV file; one of the same command is continued. Of shards, their folder")
      ->required();
  app.add_option("--jobs", options.jobs, "threads")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  impact::offer_shards(app, options.sharding);
  return impact::run_tool(app, argc, argv, [&] { impact::sweep(options); });
}
