// Error against run time, of every integrator in every kind of scene, as CSV and as plots.

#include "verification/work_precision.hpp"

#include <string>

#include "output/interruption.hpp"
#include "output/output_folder.hpp"
#include "output/program.hpp"
#include "reproduction/plotting.hpp"

namespace impact {
namespace {

/// Small enough for a test.
Effort quick_effort() {
  Effort effort;
  effort.rounds = 2;
  effort.longest = 0.1;
  effort.most = 0.05;
  effort.last_power = 4;
  effort.finer = 4.0;
  return effort;
}

void measure(WorkPrecision task, bool timing) {
  const OutputFolder output(task.folder);
  take_interruptions();
  if (task.quick) task.effort = quick_effort();
  fmt::print("{}\n", machine());
  if (timing) {
    compare_times(task);
    return;
  }
  measure_scenes(task);
  measure_discretisation(task);
  std::fflush(stdout);
  plot(task.folder, "work_precision");
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  CLI::App app(
      "Measures error against run time: of all integrators in five scenes, of the number of "
      "points; as CSV, SVG and PNG, with a summary on stdout. Times count on an idle machine only.",
      "work_precision");
  std::string folder;
  impact::WorkPrecision task;
  bool timing = false;
  app.add_option("--output", folder, "folder for the results")->required();
  app.add_flag("--timing", timing,
               "only compare the time of integrator auto with those of rk8pd and verlet, over "
               "speeds and lattices (timing.csv)");
  app.add_flag("--quick", task.quick, "small lattices and few settings: a test of the program");
  return impact::run_tool(app, argc, argv, [&] {
    task.folder = folder;
    impact::measure(task, timing);
  });
}
