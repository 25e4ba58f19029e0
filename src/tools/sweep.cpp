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

namespace impact {
namespace {

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

void sweep(const std::string& scene_file, const std::vector<std::string>& assignments,
           const std::string& output, int jobs) {
  const std::vector<Scene> scenes = parse_sweep(load_keys(scene_path(scene_file)), assignments);
  tell_if_long(scenes);
  take_interruptions();
  std::vector<Row> rows;
  {
    ProgressBar bar("sweep", scenes.size());
    rows = run_series(
        scenes, output,
        {jobs, [&bar](std::size_t /*rows*/, std::size_t runs) { bar.show(runs); }, interrupted});
  }
  fmt::print("{}", summary(rows));
  const auto failed = std::count_if(rows.begin(), rows.end(), has_failed);
  if (failed == 0) return;
  throw std::runtime_error(
      fmt::format("{} of {} runs failed: see flags in {}", failed, rows.size(), output));
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  CLI::App app("Simulates a scene for all combinations of values; a row of a CSV file a run.",
               "sweep");
  std::string scene_file;
  std::vector<std::string> assignments;
  std::string output;
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  app.add_option("scene", scene_file,
                 "collision, contact, absorbing_wall, stretch, or a scene file")
      ->required();
  app.add_option("assignments", assignments, "key=v1,v2,... or key=lo:hi:n or key=lo:hi:n:log");
  app.add_option("--output", output, "CSV file; one of the same command is continued")->required();
  app.add_option("--jobs", jobs, "threads")->capture_default_str()->check(CLI::Range(1, 1024));
  return impact::run_tool(app, argc, argv,
                          [&] { impact::sweep(scene_file, assignments, output, jobs); });
}
