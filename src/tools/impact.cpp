// One run of a scene without a ROS master: result as YAML on stdout, progress on stderr.

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "lattice/lammps_data.hpp"
#include "run/compose.hpp"
#include "run/forecast.hpp"
#include "scene/scene_parameters.hpp"
#include "tools/experiment.hpp"
#include "tools/interruption.hpp"
#include "tools/output_folder.hpp"
#include "tools/program.hpp"
#include "tools/reference_integrator.hpp"

namespace impact {
namespace {

using Clock = std::chrono::steady_clock;

void perform(Experiment& experiment) {
  constexpr std::chrono::milliseconds kRedraw{200};
  const bool show_progress = isatty(STDERR_FILENO) != 0;
  Clock::time_point last_progress = Clock::now();
  while (!experiment.finished()) {
    experiment.advance(interrupted);
    if (interrupted()) throw std::runtime_error("interrupted");
    if (show_progress && Clock::now() - last_progress > kRedraw) {
      last_progress = Clock::now();
      const Run& run = experiment.run();
      fmt::print(stderr, "\r{:.4g} R/c of about {:.2g}", run.state().time, run.expected_time());
    }
  }
  if (show_progress) fmt::print(stderr, "\r\033[K");
}

void tell_if_long(const Experiment& experiment) {
  const Run& run = experiment.run();
  const Lattice* const wall = run.wall_lattice();
  const Forecast expected = forecast(experiment.scene(), run.lattice().points.rows(),
                                     wall == nullptr ? 0 : wall->points.rows());
  if (expected.seconds <= kWorthTelling) return;
  fmt::print(stderr, "impact: this scene will take about {}\n", text(expected));
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error(fmt::format("{} cannot be written", path.string()));
}

/// Where the results go; removes what is unfinished at its end.
struct Output {
  explicit Output(const std::string& path)
      : folder(path),
        files(path,
              {"result.yaml", "scene.yaml", "history.csv", "lattice.data", "wall.data", kStates}) {}
  static constexpr const char* kStates = "states.lammpstrj";
  OutputFolder folder;
  ResultFiles files;
};

void write_result(const Experiment& experiment, const std::string& result, const History& history,
                  ResultFiles& files) {
  const double mass = experiment.run().motion().field().point_mass;
  write_file(files.beside("result.yaml"), result);
  write_file(files.beside("scene.yaml"), to_yaml(experiment.scene()));
  write_file(files.beside("history.csv"), history.csv());
  write_lammps_data(experiment.run().lattice(), mass, files.beside("lattice.data"));
  if (const Lattice* const wall = experiment.run().wall_lattice()) {
    write_lammps_data(*wall, mass, files.beside("wall.data"));
  }
  files.take_their_places();
}

FlatTree keys_of(const std::string& scene_file, const std::vector<std::string>& assignments) {
  FlatTree keys = load_keys(scene_file);
  for (const std::string& assignment : assignments) override_key(keys, assignment);
  return keys;
}

void check(const FlatTree& keys) {
  for (const Scene& scene : parse_series(keys)) {
    refuse_impossible(scene);
  }
}

void perform(const FlatTree& keys, const std::string& folder, bool keep_states) {
  if (keep_states && folder.empty()) throw InputError("--states needs --output");
  for (const auto& [key, value] : keys) {
    if (value.IsSequence()) throw bad_value(key, one_line(value), "one value; sweep takes several");
  }
  const Scene scene = parse_scene(keys);
  std::optional<Output> output;
  std::optional<History> history;
  if (!folder.empty()) {
    take_interruptions();
    output.emplace(folder);
    history.emplace(keep_states ? output->files.beside(Output::kStates) : "");
  }
  Experiment experiment(scene, history ? &*history : nullptr);
  tell_if_long(experiment);
  perform(experiment);

  const std::string result = YAML::Dump(experiment.result()) + "\n";
  fmt::print("{}", result);
  if (!output) return;
  history->close();
  write_result(experiment, result, *history, output->files);
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  impact::offer_reference_integrator();
  CLI::App app("Simulates one scene and prints what came out as YAML.", "impact");
  std::string scene_file;
  std::vector<std::string> assignments;
  std::string folder;
  bool check_only = false;
  bool keep_states = false;
  app.add_option("scene", scene_file, "scene file, like launch/scenes/collision.yaml")->required();
  app.add_option("assignments", assignments, "key=value, replaces that key of the scene");
  app.add_flag("--check", check_only,
               "only say whether the scene can be read; a list of values is a series");
  app.add_option("--output", folder,
                 "folder for result.yaml, scene.yaml, history.csv, lattice.data and wall.data");
  app.add_flag("--states", keep_states,
               "also all states at the output times, into states.lammpstrj, a LAMMPS dump");
  return impact::run_tool(app, argc, argv, [&] {
    const impact::FlatTree keys = impact::keys_of(scene_file, assignments);
    check_only ? impact::check(keys) : impact::perform(keys, folder, keep_states);
  });
}
