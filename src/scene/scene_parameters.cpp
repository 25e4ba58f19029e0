#include "scene/scene_parameters.hpp"

#include <fmt/ranges.h>

#include <cmath>
#include <set>

#include "mechanics/body.hpp"

namespace impact {
namespace {

using P = Parameter<Scene>;
using Keys = std::vector<P>;
/// Rounding of positions, 10⁻¹⁶ R, is then less than 10⁻⁷ of the elongations of the bonds.
constexpr double kLeastStrain = 1e-6;

/// c. Rounding of positions then changes the energy by less than 10⁻² of the impact's.
constexpr double kSlowest = 1e-9;

/// Degrees. Beyond it the disk flies along the wall rather than against it.
constexpr double kSteepestAngle = 85.0;

using Condition = std::function<bool(const Scene&)>;

P only(const Condition& condition, P parameter) {
  parameter.applies = condition;
  return parameter;
}

Condition in(SceneKind kind) {
  return [kind](const Scene& scene) { return scene.kind == kind; };
}

bool is_moved(const Scene& scene) { return scene.kind != SceneKind::kStretch; }

bool has_elastic_wall(const Scene& scene) {
  return is_moved(scene) && scene.wall.kind == WallKind::kLattice;
}

bool meets_disks(const Scene& scene) {
  return is_moved(scene) && scene.wall.kind == WallKind::kDisk;
}

bool falls(const Scene& scene) {
  return scene.kind == SceneKind::kCollision && !meets_disks(scene);
}

bool meets_points(const Scene& scene) { return has_elastic_wall(scene) || meets_disks(scene); }

Keys scene_keys() {
  return {
      choice<Scene, SceneKind>(
          "scene",
          {{"contact", SceneKind::kContact},
           {"collision", SceneKind::kCollision},
           {"stretch", SceneKind::kStretch}},
          "what is simulated: the disk pressed on the wall or thrown at it, or a rectangle of its "
          "recipe pulled",
          [](auto& s) -> auto& { return s.kind; }),
      whole<Scene>(
          "seed", 0, std::numeric_limits<std::int64_t>::max(),
          "of all randomness: placement and orientation", [](auto& s) -> auto& { return s.seed; })};
}

Keys disk_keys() {
  return {
      whole<Scene>(
          "disk.points", 3, 100000000,
          "number N of mass points, rim included, above 1000000 for LAMMPS only (to_lammps); sets "
          "the density of a stretched "
          "rectangle and of an elastic wall",
          [](auto& s) -> auto& { return s.disk.recipe.points; }),
      choice<Scene, Placement>(
          "disk.placement",
          {{"uniform", Placement::kUniform}, {"blue_noise", Placement::kBlueNoise}},
          "independent uniform points, or no two closer than 0.6 √(π/N) R",
          [](auto& s) -> auto& { return s.disk.recipe.placement; }),
      only(is_moved, flag<Scene>(
                         "disk.rim", "⌊2π/√(π/N)⌋ of the points evenly on the circle",
                         [](auto& s) -> auto& { return s.disk.recipe.rim; })),
      only(is_moved,
           text<Scene>(
               "disk.file", "LAMMPS data file of a lattice that replaces points, placement and rim",
               [](auto& s) -> auto& { return s.disk.file; })),
      only(is_moved,
           choice<Scene, FileScale>(
               "disk.scale", {{"none", FileScale::kNone}, {"radius", FileScale::kRadius}},
               "of the lengths in disk.file: none, for a radius of 0.8 … 1.2, or radius: made 1",
               [](auto& s) -> auto& { return s.disk.scale; })),
      only(is_moved, choice<Scene, Orientation>(
                         "disk.orientation",
                         {{"random", Orientation::kRandom}, {"balanced", Orientation::kBalanced}},
                         "random, or turned so that the centre of mass lies over the point that "
                         "touches first: then an impact gives the disk little spin",
                         [](auto& s) -> auto& { return s.disk.orientation; }))};
}

Keys material_keys() {
  return {real<Scene>(
              "material.k_a", "M c²/R²", {0.0, 1e6, false}, "linear stiffness of a bond",
              [](auto& s) -> auto& { return s.material.k_a; }),
          real<Scene>(
              "material.k_b", "M c²/R⁴", {0.0, 1e12}, "cubic stiffness of a bond",
              [](auto& s) -> auto& { return s.material.k_b; }),
          only(is_moved, real<Scene>(
                             "material.eta", "(M/N) c/R", {0.0, 1e6},
                             "viscosity η* of a bond; above 0 where a contact is to come "
                             "to rest by motion",
                             [](auto& s) -> auto& { return s.material.eta; }))};
}

Keys wall_keys() {
  return {only(is_moved, choice<Scene, WallKind>(
                             "wall.type",
                             {{"potential", WallKind::kPotential},
                              {"lattice", WallKind::kLattice},
                              {"disk", WallKind::kDisk}},
                             "what the disk meets: the wall V₀ exp(−a y) or, in a collision, an "
                             "elastic lattice, or "
                             "another disk that is free",
                             [](auto& s) -> auto& { return s.wall.kind; })),
          only(is_moved, real<Scene>(
                             "wall.a", "1/R", {1.0, 1e6}, "inverse range of the wall's repulsion",
                             [](auto& s) -> auto& { return s.wall.a; })),
          only(is_moved, real_or_auto<Scene>(
                             "wall.V0", "M c²", {0.0, 1e6, false},
                             "energy of the repulsion; auto: a R (M/N) c², half "
                             "of it for an elastic wall or a disk",
                             [](auto& s) -> auto& { return s.wall.v0; }))};
}

Keys where(const Condition& condition, Keys table) {
  for (P& parameter : table) parameter.applies = condition;
  return table;
}

Keys other_body_keys() {
  return where(meets_points,
               {real_or_auto<Scene>(
                    "wall.k_a", "M c²/R²", {0.0, 1e6, false},
                    "elastic wall or disk: linear stiffness of a bond; auto: as in the first disk",
                    [](auto& s) -> auto& { return s.wall.k_a; }),
                real_or_auto<Scene>(
                    "wall.k_b", "M c²/R⁴", {0.0, 1e12},
                    "elastic wall or disk: cubic stiffness of a bond; auto: as in the first disk",
                    [](auto& s) -> auto& { return s.wall.k_b; }),
                real_or_auto<Scene>(
                    "wall.eta", "(M/N) c/R", {0.0, 1e6},
                    "elastic wall or disk: viscosity of a bond; auto: as in the first disk",
                    [](auto& s) -> auto& { return s.wall.eta; }),
                real<Scene>(
                    "wall.threshold", "R", {0.0, 10.0, false},
                    "elastic wall or disk: gap below which a point feels the surface",
                    [](auto& s) -> auto& { return s.wall.threshold; }),
                text<Scene>(
                    "wall.file",
                    "LAMMPS data file of a wall that replaces points, width and height: a "
                    "rectangle with points along its sides; or of a disk, replacing radius",
                    [](auto& s) -> auto& { return s.wall.file; })});
}

Keys row_keys() {
  return where(meets_disks,
               {real<Scene>(
                    "wall.radius", "R", {0.05, 20.0},
                    "disk: its radius, with points of the same mass, as dense as in the first one",
                    [](auto& s) -> auto& { return s.wall.radius; }),
                flag<Scene>(
                    "wall.mirrored",
                    "disk: the mirror image of the one above it, in place of radius and file",
                    [](auto& s) -> auto& { return s.wall.mirrored; }),
                whole<Scene>(
                    "wall.disks", 1, static_cast<int>(kMostBodies) - 1,
                    "disk: how many stand in a row, one below another, just out of contact",
                    [](auto& s) -> auto& { return s.wall.disks; })});
}

Keys elastic_wall_keys() {
  return where(
      has_elastic_wall,
      {whole<Scene>(
           "wall.points", 3, 1000000, "elastic wall: number of mass points",
           [](auto& s) -> auto& { return s.wall.points; }),
       real_or_auto<Scene>(
           "wall.width", "R", {0.1, 1000.0},
           "elastic wall: width; auto: by the disk's number density, and twice the "
           "height where that is auto too",
           [](auto& s) -> auto& { return s.wall.width; }),
       real_or_auto<Scene>(
           "wall.height", "R", {0.1, 1000.0},
           "elastic wall: height; auto: by the disk's number density",
           [](auto& s) -> auto& { return s.wall.height; }),
       choice<Scene, GapMeasure>(
           "wall.gap_measure",
           {{"normal", GapMeasure::kNormal}, {"vertical", GapMeasure::kVertical}},
           "elastic wall: gap perpendicular to the bond, or along y: continuous from bond to bond",
           [](auto& s) -> auto& { return s.wall.gap; }),
       choice<Scene, Boundary>(
           "wall.boundary",
           {{"reset", Boundary::kReset},
            {"fixed", Boundary::kFixed},
            {"viscous", Boundary::kViscous}},
           "elastic wall, left, right and bottom side: velocities set to zero at intervals, points "
           "clamped, or dashpots that absorb waves",
           [](auto& s) -> auto& { return s.wall.boundary; }),
       real<Scene>(
           "wall.reset_interval", "R/c", {1e-6, 1000.0},
           "elastic wall, boundary reset: time between resets; the step is shortened to divide it",
           [](auto& s) -> auto& { return s.wall.reset_interval; })});
}

Keys task_keys() {
  return {only(in(SceneKind::kContact), real<Scene>(
                                            "load.P", "M c²/R", {0.0, 1.0, false},
                                            "contact: compression, spread evenly over the points",
                                            [](auto& s) -> auto& { return s.load.p; })),
          only(in(SceneKind::kContact),
               flag<Scene>(
                   "load.hold_rotation",
                   "contact: hold the rigid rotation by a torque; false: it may roll",
                   [](auto& s) -> auto& { return s.load.hold_rotation; })),
          only(in(SceneKind::kCollision),
               real<Scene>(
                   "impact.velocity", "c", {kSlowest, 1.0},
                   "collision: speed of the centre of mass at the start, of two disks "
                   "against each other; "
                   "slower ones lose their energy in rounding",
                   [](auto& s) -> auto& { return s.impact.velocity; })),
          only(in(SceneKind::kCollision),
               real<Scene>(
                   "impact.angle", "degrees", {-kSteepestAngle, kSteepestAngle},
                   "collision: of the velocity from the wall's normal, towards +x",
                   [](auto& s) -> auto& { return s.impact.angle; })),
          only(in(SceneKind::kCollision),
               real<Scene>(
                   "impact.spin", "c/R", {-1.0, 1.0},
                   "collision: of the disk at the start, counter-clockwise; it starts stretched as "
                   "a disk that spins steadily",
                   [](auto& s) -> auto& { return s.impact.spin; })),
          only(in(SceneKind::kCollision),
               real_or_auto<Scene>(
                   "impact.gap", "R", {-1.0, 100.0},
                   "collision: height of the lowest point at the start; "
                   "auto: half an R/c before the wall's "
                   "energy is error/100 of the kinetic energy, and a whole number of resets before "
                   "height 0",
                   [](auto& s) -> auto& { return s.impact.gap; })),
          only(falls,
               real<Scene>(
                   "gravity", "c²/R", {0.0, 1.0},
                   "collision with a wall: acceleration of the disk towards it; e is then that of "
                   "the velocities where the disk touches",
                   [](auto& s) -> auto& { return s.gravity; })),
          only(in(SceneKind::kStretch),
               real<Scene>(
                   "stretch.width", "R", {0.1, 1000.0}, "stretch: of the rectangle",
                   [](auto& s) -> auto& { return s.stretch.width; })),
          only(in(SceneKind::kStretch),
               real<Scene>(
                   "stretch.height", "R", {0.1, 1000.0}, "stretch: of the rectangle",
                   [](auto& s) -> auto& { return s.stretch.height; })),
          only(in(SceneKind::kStretch),
               real<Scene>(
                   "stretch.strain", "-", {-0.1, 0.1},
                   "stretch: how much the grips draw its ends apart, over the width; at least "
                   "1e-6 in size",
                   [](auto& s) -> auto& { return s.stretch.strain; }))};
}

/// "bdf or rk8pd".
std::string adaptive_names() {
  std::vector<std::string> names;
  for (const IntegratorTraits& method : kIntegrators) {
    if (is_adaptive(method.kind)) names.emplace_back(method.name);
  }
  return fmt::format("{}", fmt::join(names, " or "));
}

Keys numerics_keys() {
  return {choice<Scene, IntegratorKind>(
              "numerics.integrator", integrator_names(),
              "method (integrators.md); auto: the fastest that gives the answer to "
              "within the wanted error",
              [](auto& s) -> auto& { return s.numerics.integrator; }),
          only(is_moved, real_or_auto<Scene>(
                             "numerics.step", "R/c", {0.0, 10.0, false},
                             "step of a method of fixed step; auto: the longest that gives the "
                             "answer to within the wanted error",
                             [](auto& s) -> auto& { return s.numerics.step; })),
          only(is_moved, real_or_auto<Scene>(
                             "numerics.tolerance", "-", {1e-14, 1.0},
                             "relative tolerance of a step of " + adaptive_names() +
                                 "; auto: the largest that gives the answer to within the wanted "
                                 "error",
                             [](auto& s) -> auto& { return s.numerics.tolerance; })),
          real<Scene>(
              "numerics.error", "-", {1e-10, 1e-2},
              "wanted relative error of the answer, restitution or strain",
              [](auto& s) -> auto& { return s.numerics.error; }),
          real<Scene>(
              "numerics.longest", "s", {0.0, 1e9, false},
              "a scene that is forecast to take longer on one processor is refused",
              [](auto& s) -> auto& { return s.numerics.longest; }),
          only(is_moved, real<Scene>(
                             "output.period", "R/c", {1e-6, 1e6},
                             "time between published states, rounded to whole steps",
                             [](auto& s) -> auto& { return s.output.period; }))};
}

Keys make_table() {
  Keys table;
  for (const auto& part :
       {scene_keys(), disk_keys(), material_keys(), wall_keys(), other_body_keys(),
        elastic_wall_keys(), row_keys(), task_keys(), numerics_keys()}) {
    table.insert(table.end(), part.begin(), part.end());
  }
  return table;
}

/// What keeps a scene from being a slow impact of less than all points; empty: nothing.
std::string beyond_slow_impact(const Scene& scene) {
  if (scene.kind != SceneKind::kCollision) return "a contact or stretch scene";
  if (scene.wall.kind != WallKind::kPotential) return "a wall that moves (wall.type)";
  if (scene.gravity != 0.0) return "gravity";
  if (scene.impact.spin != 0.0) return "a disk that spins at the start (impact.spin)";
  return "";
}

/// The same of one of rigid motion and static compliance.
std::string beyond_reduced(const Scene& scene) {
  const std::string more = beyond_slow_impact(scene);
  return more.empty() && scene.is_damped() ? "damping (material.eta above 0)" : more;
}

/// The same of one of modes.
std::string beyond_modal(const Scene& scene) {
  const std::string more = beyond_slow_impact(scene);
  return more.empty() && scene.impact.angle != 0.0 ? "an oblique impact (impact.angle)" : more;
}

std::string beyond(IntegratorKind kind, const Scene& scene) {
  if (kind == IntegratorKind::kReduced) return beyond_reduced(scene);
  if (kind == IntegratorKind::kModal) return beyond_modal(scene);
  return "";
}

/// Which integrators a scene may have.
void check_integrator(const Scene& scene) {
  const IntegratorKind kind = scene.numerics.integrator;
  const auto refuse = [&](const std::string& allowed) {
    throw bad_value("numerics.integrator", name_of(kind), allowed);
  };
  if (kind == IntegratorKind::kAuto) return;
  const IntegratorTraits& method = traits_of(kind);
  const bool still = method.stepping == Stepping::kStatic;
  if (still && scene.kind == SceneKind::kCollision) {
    refuse("a method of motion in a collision, not a static solution");
  }
  if (!still && scene.kind == SceneKind::kStretch) refuse("auto or newton in a stretch scene");
  if (const std::string more = beyond(kind, scene); !more.empty()) {
    refuse(fmt::format("another one with {}, which {} does not have", more, name_of(kind)));
  }
  if (!method.holds_with_damping && scene.is_damped()) {
    refuse(
        "another one where forces depend on velocities (material.eta above 0 or a viscous "
        "boundary), on which its order does not hold");
  }
  if (!method.holds_with_passing && scene.has_passing_contacts()) {
    refuse("another one where contacts pass from bond to bond (wall.type other than potential)");
  }
}

/// Whether the integrator goes with a step or with a tolerance.
void check_resolution(const Scene& scene) {
  const Scene::Numerics& numerics = scene.numerics;
  const bool adaptive = is_adaptive(numerics.integrator);
  const bool fixed = !adaptive && !scene.is_static();
  if (numerics.step && !fixed) {
    throw bad_value(
        "numerics.step", fmt::format("{}", *numerics.step),
        fmt::format("auto with {}", adaptive ? "an integrator that chooses its steps by "
                                               "numerics.tolerance"
                                             : "a static solution"));
  }
  if (numerics.tolerance && !adaptive) {
    throw bad_value("numerics.tolerance", fmt::format("{}", *numerics.tolerance),
                    "auto unless numerics.integrator is " + adaptive_names());
  }
}

/// Equal for equal values, however they are written.
std::string canonical(const YAML::Node& value) {
  const auto whole = whole_number(value);
  const auto real = real_number(value);
  if (whole || !real) return one_line(value);
  return fmt::format("{}", *real);
}

/// One run would count as two.
void refuse_repetitions(const std::string& key, const YAML::Node& list) {
  std::set<std::string> values;
  for (const YAML::Node& value : list) {
    if (!values.insert(canonical(value)).second) {
      throw bad_value(key, one_line(list), "no value twice");
    }
  }
}

void check_combination(const Scene& scene) {
  check_integrator(scene);
  check_resolution(scene);
  if (scene.kind == SceneKind::kStretch && std::abs(scene.stretch.strain) < kLeastStrain) {
    throw bad_value("stretch.strain", fmt::format("{}", scene.stretch.strain),
                    fmt::format("at most -{0} or at least {0}", kLeastStrain));
  }
  if (scene.kind == SceneKind::kContact && scene.wall.kind != WallKind::kPotential) {
    throw bad_value("wall.type", scene.wall.kind == WallKind::kLattice ? "lattice" : "disk",
                    "potential in a contact scene");
  }
  if (meets_disks(scene) && scene.wall.mirrored &&
      (scene.wall.radius != 1.0 || !scene.wall.file.empty())) {
    throw bad_value("wall.mirrored", "true", "false with a radius or a file of its own");
  }
  if (scene.kind == SceneKind::kContact && !scene.is_static() && scene.material.eta == 0.0) {
    throw bad_value("material.eta", "0",
                    "above 0 where a contact comes to rest by motion (or integrator auto, newton)");
  }
}

}  // namespace

const std::vector<std::pair<std::string, IntegratorKind>>& integrator_names() {
  static const std::vector<std::pair<std::string, IntegratorKind>> names = [] {
    std::vector<std::pair<std::string, IntegratorKind>> list;
    list.reserve(kIntegrators.size());
    for (const IntegratorTraits& method : kIntegrators) list.emplace_back(method.name, method.kind);
    return list;
  }();
  return names;
}

bool can_be_reduced(const Scene& scene) { return beyond_reduced(scene).empty(); }

bool can_be_modal(const Scene& scene) { return beyond_modal(scene).empty(); }

std::string name_of(IntegratorKind kind) { return traits_of(kind).name; }

const std::vector<Parameter<Scene>>& scene_parameters() {
  static const std::vector<Parameter<Scene>> table = make_table();
  return table;
}

Scene parse_scene(const FlatTree& keys, const std::vector<std::string>& other_names) {
  if (keys.count("scene") == 0) {
    throw bad_value("scene", "nothing", scene_parameters().front().allowed);
  }
  Scene scene;
  read_parameters(scene_parameters(), keys, scene, other_names);
  check_combination(scene);
  return scene;
}

Scene parse_single_scene(const FlatTree& keys) {
  for (const auto& [key, value] : keys) {
    if (value.IsSequence()) throw bad_value(key, one_line(value), "one value; sweep takes several");
  }
  return parse_scene(keys);
}

std::vector<Scene> parse_combinations(FlatTree keys, const std::vector<KeyValues>& lists,
                                      const std::vector<std::string>& other_names) {
  std::size_t count = 1;
  for (const auto& [key, values] : lists) {
    if (values.size() == 0) throw bad_value(key, "[]", "one value at least");
    refuse_repetitions(key, values);
    count *= values.size();
    if (count > kMostScenes) {
      throw InputError(fmt::format("{}: more than {} combinations", shown(key), kMostScenes));
    }
  }
  std::vector<Scene> scenes;
  scenes.reserve(count);
  for (std::size_t number = 0; number < count; ++number) {
    std::size_t rest = number;
    for (auto list = lists.rbegin(); list != lists.rend(); ++list) {
      keys[list->first].reset(list->second[rest % list->second.size()]);
      rest /= list->second.size();
    }
    scenes.push_back(parse_scene(keys, other_names));
  }
  return scenes;
}

std::vector<KeyValues> lists_of(const FlatTree& keys) {
  std::vector<KeyValues> lists;
  for (const auto& [key, value] : keys) {
    if (value.IsSequence()) lists.emplace_back(key, value);
  }
  return lists;
}

std::vector<Scene> parse_series(const FlatTree& keys, const std::vector<std::string>& other_names) {
  return parse_combinations(keys, lists_of(keys), other_names);
}

std::string to_yaml(const Scene& scene) {
  return YAML::Dump(write_parameters(scene_parameters(), scene)) + "\n";
}

}  // namespace impact
