// What the units of a simulation are in SI for a disk of a real material: values of a scene from
// SI, results in SI.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "output/program.hpp"
#include "output/result_text.hpp"
#include "output/si_units.hpp"
#include "scene/disk_elasticity.hpp"
#include "scene/keys.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

/// What else may be given: of the lattice, and quantities in SI that become values of a scene.
struct Wanted {
  Scene scene;
  double velocity = RealDisk::kNaN;      ///< m/s
  double load = RealDisk::kNaN;          ///< N, or N/m
  double period = RealDisk::kNaN;        ///< s
  double damping_time = RealDisk::kNaN;  ///< s
};

const std::vector<Parameter<Wanted>>& wanted_parameters() {
  using P = Wanted;
  constexpr Interval kAny{0.0, 1e15, false};
  static const std::vector<Parameter<P>> table{
      real<P>(
          "velocity", "m/s", kAny, "becomes impact.velocity",
          [](auto& p) -> auto& { return p.velocity; }),
      real<P>(
          "load", "N, or N/m without a thickness", kAny, "becomes load.P",
          [](auto& p) -> auto& { return p.load; }),
      real<P>(
          "period", "s", kAny, "becomes output.period", [](auto& p) -> auto& { return p.period; }),
      real<P>(
          "damping_time", "s", kAny, "η/k_a of a bond, becomes material.eta",
          [](auto& p) -> auto& { return p.damping_time; }),
      real<P>(
          "k_a", "M c²/R²", kAny, "material.k_a of the scene",
          [](auto& p) -> auto& { return p.scene.material.k_a; }),
      whole<P>(
          "points", 3, 1000000, "disk.points of the scene",
          [](auto& p) -> auto& { return p.scene.disk.recipe.points; }),
      choice<P, Placement>(
          "placement", {{"blue_noise", Placement::kBlueNoise}, {"uniform", Placement::kUniform}},
          "disk.placement of the scene",
          [](auto& p) -> auto& { return p.scene.disk.recipe.placement; })};
  return table;
}

struct Task {
  RealDisk disk;
  Wanted wanted;
};

Task parse(const std::vector<std::string>& assignments) {
  FlatTree of_disk;
  FlatTree of_rest;
  const std::vector<std::string> disk_names = key_names(real_disk_parameters(), RealDisk{});
  for (const std::string& text : assignments) {
    const auto [key, value] = parse_assignment(text);
    const bool is_of_disk =
        std::find(disk_names.begin(), disk_names.end(), key) != disk_names.end();
    if (!(is_of_disk ? of_disk : of_rest).emplace(key, parse_value(key, value)).second) {
      throw InputError(shown(key) + ": given twice");
    }
  }
  Task task;
  read_parameters(wanted_parameters(), of_rest, task.wanted, disk_names);
  task.disk = parse_real_disk(of_disk);
  return task;
}

/// The keys of a scene that a quantity in SI becomes.
std::vector<std::pair<const char*, double>> scene_keys(const Wanted& wanted, const SiUnits& si) {
  std::vector<std::pair<const char*, double>> keys;
  const auto add = [&](const char* key, double value, const char* unit, double factor = 1.0) {
    if (!std::isnan(value)) keys.emplace_back(key, factor * value / si.in_si(1.0, unit)->value);
  };
  add("impact.velocity", wanted.velocity, "c");
  add("load.P", wanted.load, "M c²/R");
  add("output.period", wanted.period, "R/c");
  // η* (M/N) c/R over k_a M c²/R².
  add("material.eta", wanted.damping_time, "R/c",
      wanted.scene.material.k_a * wanted.scene.disk.recipe.points);
  return keys;
}

struct Row {
  const char* key;
  const char* unit;
};

constexpr std::array<Row, 7> kRows{{{"length", "R"},
                                    {"speed", "c"},
                                    {"time", "R/c"},
                                    {"mass", "M"},
                                    {"force", "M c²/R"},
                                    {"energy", "M c²"},
                                    {"stiffness", "M c²/R²"}}};

YAML::Node tree(const Task& task, const SiUnits& si) {
  const DiskElasticity lattice = disk_elasticity(task.wanted.scene, {});
  YAML::Node node;
  YAML::Node units;
  for (const Row& row : kRows) {
    const Measure measure = *si.in_si(1.0, row.unit);
    node[row.key] = exact(measure.value);
    units[row.key] = measure.unit;
  }
  node["units"] = units;
  node["young_modulus"] = exact(lattice.young_modulus.value);
  node["poisson_ratio"] = exact(lattice.poisson_ratio.value);
  node["scene"] = YAML::Node(YAML::NodeType::Map);
  for (const auto& [key, value] : scene_keys(task.wanted, si)) node["scene"][key] = exact(value);
  return node;
}

std::string text(const Task& task, const SiUnits& si) {
  std::string text = "A disk of " + si.origin() + "\n\n";
  for (const Row& row : kRows) {
    const Measure measure = *si.in_si(1.0, row.unit);
    text += fmt::format("  {:<9}  {:<7}  = {:.5g} {}\n", row.key, row.unit, measure.value,
                        measure.unit);
  }
  for (const auto& [key, value] : scene_keys(task.wanted, si)) {
    text += fmt::format("  {}={:.6g}\n", key, value);
  }
  return text;
}

void show_units(const Task& task, Format format) {
  const SiUnits si(task.disk, task.wanted.scene);
  if (is_text(format)) {
    fmt::print("{}", text(task, si));
  } else {
    const YAML::Node node = tree(task, si);
    print_document(node, format);
  }
}

/// Of a folder that impact has written.
void show_result(const Task& task, const std::filesystem::path& folder, Format format) {
  const Scene scene = parse_scene(load_keys(folder / "scene.yaml"));
  const SiUnits si(task.disk, scene);
  YAML::Node file;
  try {
    file = YAML::LoadFile(folder / "result.yaml");
  } catch (const YAML::Exception& error) {
    throw InputError(fmt::format("{}: {}", (folder / "result.yaml").string(), error.msg));
  }
  if (!file.IsMap()) throw InputError((folder / "result.yaml").string() + ": no result");
  const Result result = read_result(file);
  if (is_text(format)) {
    fmt::print("{}\n{}  SI for {}\n", title(scene), result_block(result, scene, si), si.origin());
  } else {
    const YAML::Node node = si_values(result, scene, si);
    print_document(node, format);
  }
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  CLI::App app(
      "Says what the units of a simulation are in SI for a disk of a real material, and what "
      "values "
      "of a scene quantities in SI become.",
      "units");
  std::vector<std::string> assignments;
  std::string folder;
  impact::Format format = impact::Format::kAuto;
  app.add_option("assignments", assignments,
                 "key=value: radius, density or mass, young or wave_speed, thickness")
      ->required();
  app.add_option("--result", folder, "show the result in this folder of impact --output in SI");
  impact::offer_formats(app, format);
  app.footer("Keys:\n" +
             impact::parameter_list(impact::real_disk_parameters(), impact::RealDisk{}) +
             impact::parameter_list(impact::wanted_parameters(), impact::Wanted{}));
  return impact::run_tool(app, argc, argv, [&] {
    const impact::Task task = impact::parse(assignments);
    folder.empty() ? impact::show_units(task, format) : impact::show_result(task, folder, format);
  });
}
