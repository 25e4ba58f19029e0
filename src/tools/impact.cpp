// One run of a scene without a ROS master: result as YAML on stdout, progress on stderr.

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "lattice/lammps_data.hpp"
#include "measure/impact_analysis.hpp"
#include "measure/strain.hpp"
#include "run/run.hpp"
#include "scene/scene_parameters.hpp"
#include "tools/program.hpp"
#include "tools/restitution_yaml.hpp"

namespace impact {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The line of the present state in history.csv.
std::string history_line(const Run& run, const Strain& strain, double force) {
  const EnergyLedger ledger = run.simulation().ledger();
  return fmt::format("{},{},{},{},{},{},{},{}\n", run.state().time, strain.strain(), force,
                     ledger.kinetic(), ledger.bonds, ledger.wall, ledger.load, ledger.dissipated);
}

constexpr const char* kHistoryHeader =
    "time [R/c],strain [R],force [M c^2/R],kinetic [M c^2],bonds [M c^2],wall [M c^2],"
    "load [M c^2],dissipated [M c^2]\n";

/// Simulates and measures one scene.
class Experiment {
 public:
  Experiment(const Scene& scene, bool keep_history)
      : scene_(scene), run_(scene), strain_meter_(run_.lattice().points) {
    if (keep_history) history_ = kHistoryHeader;
    take_in();
  }

  void perform() {
    const bool show_progress = isatty(STDERR_FILENO) != 0;
    Clock::time_point last_progress = Clock::now();
    while (!run_.finished()) {
      run_.advance();
      take_in();
      if (show_progress && seconds_since(last_progress) > 0.2) {
        last_progress = Clock::now();
        fmt::print(stderr, "\r{:.4g} R/c of about {:.2g}", run_.state().time, run_.expected_time());
      }
    }
    if (show_progress) fmt::print(stderr, "\r\033[K");
  }

  YAML::Node result() const {
    YAML::Node result = scene_.kind == SceneKind::kCollision ? impact_result() : contact_result();
    result["energy_error"] = exact(run_.energy_error());
    result["integrator"] = run_.integrator();
    result["step"] = exact(run_.simulation().step_size());
    result["steps"] = run_.state().step;
    result["wall_time"] = exact(seconds_since(start_));
    add_flags(run_.flags(), result);
    return result;
  }

  const std::string& history() const { return history_; }
  const Run& run() const { return run_; }

 private:
  void take_in() {
    const ContactReport report = run_.take_contact_reports().on_disk;
    const State state = run_.disk_state();
    analysis_.add(state);
    analysis_.add(report);
    if (!history_.empty()) {
      history_ += history_line(run_, strain_meter_.measure(state.position), report.total.y());
    }
  }

  YAML::Node impact_result() const {
    const bool separated = !has_flag("not_separated");
    const Restitution restitution = analysis_.restitution(separated);
    YAML::Node result;
    result["velocity"] = exact(scene_.impact.velocity);
    add_restitution(restitution, result);
    result["restitution_bound"] = exact(run_.restitution_bound());
    return result;
  }

  YAML::Node contact_result() const {
    const Strain strain = strain_meter_.measure(run_.state().position);
    const auto& hold = run_.simulation().field().hold;
    YAML::Node result;
    result["P"] = exact(scene_.load.p);
    result["strain"] = exact(strain.strain());
    result["strain_from_radius"] = exact(strain.strain_from_radius());
    result["wall_force"] = exact(run_.simulation().field().wall->total_force().y());
    result["rotation"] = exact(strain.rotation);
    if (hold) result["hold_torque"] = exact(hold->torque());
    result["largest_static_force"] = exact(run_.simulation().largest_static_force());
    return result;
  }

  bool has_flag(const char* flag) const {
    const auto& flags = run_.flags();
    return std::find(flags.begin(), flags.end(), flag) != flags.end();
  }

  Clock::time_point start_ = Clock::now();
  Scene scene_;
  Run run_;
  StrainMeter strain_meter_;
  ImpactAnalysis analysis_;
  std::string history_;
};

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error(fmt::format("{} cannot be written", path.string()));
}

void perform(const std::string& scene_file, const std::vector<std::string>& assignments,
             const std::string& folder) {
  FlatTree keys = load_keys(scene_file);
  for (const std::string& assignment : assignments) override_key(keys, assignment);
  const Scene scene = parse_scene(keys);
  Experiment experiment(scene, !folder.empty());
  if (!folder.empty()) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw InputError(fmt::format("--output: {}: {}", folder, error.message()));
  }
  experiment.perform();

  const std::string result = YAML::Dump(experiment.result()) + "\n";
  fmt::print("{}", result);
  if (folder.empty()) return;
  const std::filesystem::path path(folder);
  write_file(path / "result.yaml", result);
  write_file(path / "scene.yaml", to_yaml(scene));
  write_file(path / "history.csv", experiment.history());
  write_lammps_data(experiment.run().lattice(), experiment.run().simulation().field().point_mass,
                    path / "lattice.data");
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  CLI::App app("Simulates one scene and prints what came out as YAML.", "impact");
  std::string scene_file;
  std::vector<std::string> assignments;
  std::string folder;
  app.add_option("scene", scene_file, "scene file, like launch/scenes/collision.yaml")->required();
  app.add_option("assignments", assignments, "key=value, replaces that key of the scene");
  app.add_option("--output", folder,
                 "folder for result.yaml, scene.yaml, history.csv, lattice.data");
  return impact::run_tool(app, argc, argv,
                          [&] { impact::perform(scene_file, assignments, folder); });
}
