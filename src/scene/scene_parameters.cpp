#include "scene/scene_parameters.hpp"

#include <fmt/format.h>

namespace impact {
namespace {

using P = Parameter<Scene>;

P only_in(SceneKind kind, P parameter) {
  parameter.applies = [kind](const Scene& scene) { return scene.kind == kind; };
  return parameter;
}

std::vector<P> make_table() {
  std::vector<P> table;
  table.push_back(choice<Scene, SceneKind>(
      "scene", {{"contact", SceneKind::kContact}, {"collision", SceneKind::kCollision}},
      "what is simulated: the disk pressed on the wall, or thrown at it",
      [](Scene & s) -> auto& { return s.kind; }));
  table.push_back(whole<Scene>(
      "seed", 0, std::numeric_limits<std::int64_t>::max(),
      "of all randomness: placement and orientation", [](Scene & s) -> auto& { return s.seed; }));

  table.push_back(whole<Scene>(
      "disk.points", 3, 1000000, "number N of mass points, rim included",
      [](Scene & s) -> auto& { return s.disk.recipe.points; }));
  table.push_back(choice<Scene, Placement>(
      "disk.placement", {{"uniform", Placement::kUniform}, {"blue_noise", Placement::kBlueNoise}},
      "independent uniform points, or no two closer than 0.6 √(π/N) R",
      [](Scene & s) -> auto& { return s.disk.recipe.placement; }));
  table.push_back(flag<Scene>(
      "disk.rim", "⌊2π/√(π/N)⌋ of the points evenly on the circle",
      [](Scene & s) -> auto& { return s.disk.recipe.rim; }));
  table.push_back(text<Scene>(
      "disk.file", "LAMMPS data file of a lattice that replaces points, placement and rim",
      [](Scene & s) -> auto& { return s.disk.file; }));

  table.push_back(real<Scene>(
      "material.k_a", "M c²/R²", {0.0, 1e6, false}, "linear stiffness of a bond",
      [](Scene & s) -> auto& { return s.material.k_a; }));
  table.push_back(real<Scene>(
      "material.k_b", "M c²/R⁴", {0.0, 1e12}, "cubic stiffness of a bond",
      [](Scene & s) -> auto& { return s.material.k_b; }));
  table.push_back(real<Scene>(
      "material.eta", "(M/N) c/R", {0.0, 1e6},
      "viscosity η* of a bond; above 0 where a contact is to come to rest by motion",
      [](Scene & s) -> auto& { return s.material.eta; }));

  table.push_back(choice<Scene, WallKind>(
      "wall.type", {{"potential", WallKind::kPotential}}, "the wall V₀ exp(−a y) below the disk",
      [](Scene & s) -> auto& { return s.wall.kind; }));
  table.push_back(real<Scene>(
      "wall.a", "1/R", {1.0, 1e6}, "inverse range of the wall",
      [](Scene & s) -> auto& { return s.wall.a; }));
  table.push_back(real_or_auto<Scene>(
      "wall.V0", "M c²", {0.0, 1e6, false}, "energy of the wall; auto: a R (M/N) c²",
      [](Scene & s) -> auto& { return s.wall.v0; }));

  table.push_back(
      only_in(SceneKind::kContact, real<Scene>(
                                       "load.P", "M c²/R", {0.0, 1.0, false},
                                       "contact: compression, spread evenly over the points",
                                       [](Scene & s) -> auto& { return s.load.p; })));
  table.push_back(only_in(
      SceneKind::kContact,
      flag<Scene>(
          "load.hold_rotation", "contact: hold the rigid rotation by a torque; false: it may roll",
          [](Scene & s) -> auto& { return s.load.hold_rotation; })));

  table.push_back(
      only_in(SceneKind::kCollision, real<Scene>(
                                         "impact.velocity", "c", {0.0, 1.0, false},
                                         "collision: speed towards the wall at the start",
                                         [](Scene & s) -> auto& { return s.impact.velocity; })));
  table.push_back(
      only_in(SceneKind::kCollision,
              real_or_auto<Scene>(
                  "impact.gap", "R", {-1.0, 100.0},
                  "collision: height of the lowest point at the start; auto: where the wall's "
                  "energy is error/100 of the kinetic energy",
                  [](Scene & s) -> auto& { return s.impact.gap; })));

  table.push_back(choice<Scene, IntegratorKind>(
      "numerics.integrator",
      {{"auto", IntegratorKind::kAuto},
       {"verlet", IntegratorKind::kVerlet},
       {"newton", IntegratorKind::kNewton}},
      "method; auto: velocity Verlet; newton: the static solution of a contact, without motion",
      [](Scene & s) -> auto& { return s.numerics.integrator; }));
  table.push_back(real_or_auto<Scene>(
      "numerics.step", "R/c", {0.0, 10.0, false},
      "largest step; auto: from the stability bound; shortened to divide the output period",
      [](Scene & s) -> auto& { return s.numerics.step; }));
  table.push_back(real<Scene>(
      "numerics.error", "-", {1e-10, 1e-2},
      "wanted relative error of the answer: sets the gap, the rest "
      "criterion and the end of a collision",
      [](Scene & s) -> auto& { return s.numerics.error; }));

  table.push_back(real<Scene>(
      "output.period", "R/c", {1e-6, 1e6}, "time between published states",
      [](Scene & s) -> auto& { return s.output.period; }));
  return table;
}

void check_combination(const Scene& scene) {
  const bool is_static = scene.numerics.integrator == IntegratorKind::kNewton;
  if (is_static && scene.kind != SceneKind::kContact) {
    throw bad_value("numerics.integrator", "newton", "auto or verlet in a scene of motion");
  }
  if (scene.kind == SceneKind::kContact && !is_static && scene.material.eta == 0.0) {
    throw bad_value(
        "material.eta", "0",
        "above 0 in a contact scene, which comes to rest by damping (or integrator newton)");
  }
}

}  // namespace

const std::vector<Parameter<Scene>>& scene_parameters() {
  static const std::vector<Parameter<Scene>> table = make_table();
  return table;
}

Scene parse_scene(const FlatTree& keys, const std::string& other_names) {
  if (keys.count("scene") == 0) {
    throw bad_value("scene", "nothing", scene_parameters().front().allowed);
  }
  Scene scene;
  read_parameters(scene_parameters(), keys, scene, other_names);
  check_combination(scene);
  return scene;
}

std::vector<Scene> parse_series(const FlatTree& keys, const std::string& other_names) {
  std::vector<FlatTree> runs{keys};
  for (const auto& entry : keys) {
    if (!entry.second.IsSequence()) continue;
    if (entry.second.size() == 0) throw bad_value(entry.first, "[]", "one value at least");
    std::vector<FlatTree> longer;
    for (const FlatTree& run : runs) {
      for (const YAML::Node& value : entry.second) {
        longer.push_back(run);
        longer.back()[entry.first].reset(value);
      }
    }
    runs = std::move(longer);
  }
  std::vector<Scene> scenes;
  scenes.reserve(runs.size());
  for (const FlatTree& run : runs) scenes.push_back(parse_scene(run, other_names));
  return scenes;
}

std::string to_yaml(const Scene& scene) {
  return YAML::Dump(write_parameters(scene_parameters(), scene)) + "\n";
}

FlatTree load_keys(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) {
    throw InputError(fmt::format("{}: cannot be read", path.string()));
  }
  try {
    return flatten(YAML::LoadFile(path.string()));
  } catch (const YAML::BadFile&) {
    throw InputError(fmt::format("{}: cannot be read", path.string()));
  } catch (const YAML::Exception& error) {
    throw InputError(fmt::format("{}:{}: {}", path.string(), error.mark.line + 1, error.msg));
  }
}

void override_key(FlatTree& keys, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == 0 || equals == std::string::npos) {
    throw InputError(fmt::format("{}: allowed: key=value", assignment));
  }
  const std::string key = assignment.substr(0, equals);
  try {
    keys[key].reset(YAML::Load(assignment.substr(equals + 1)));
  } catch (const YAML::Exception& error) {
    throw InputError(fmt::format("{}: {}", key, error.msg));
  }
}

}  // namespace impact
