#include "run/lammps_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "run/expected_time.hpp"
#include "run/run.hpp"
#include "scene/keys.hpp"
#include "scene/scene_parameters.hpp"
#include "scene/version.hpp"

namespace impact {
namespace {

// Each bond has its own natural length, so its own type. Atoms stay in the order of our lattice and
// on the processor that has them at the start: no point comes to have other neighbours, so there
// are no pairs, and no list is ever built again. Only points in reach of the wall are asked for its
// force. Motion and energies of the disk cost as much as the bonds, so they are not summed up at
// every step.
constexpr const char* kScript =
    R"(# An impact on the potential wall, written by to_lammps of lattice_impact {version}.
# Lengths in R, speeds in c, masses in M. Run it in this folder, on as many processors as you like:
#   mpirun -np 2 lmp -in in.lammps
echo none
units lj
dimension 2
boundary f f p
newton on
atom_style bond
atom_modify map yes sort 0 0
special_bonds lj/coul 1 1 1
comm_style tiled
comm_modify cutoff {cutoff}
neighbor 0 bin
neigh_modify once yes
pair_style none
bond_style class2
read_data start.data
include bonds.in
balance 1.05 rcb

# The disk comes down and spins.
variable vx atom ({vx})-({spin})*(y-xcm(all,y))
variable vy atom ({vy})+({spin})*(x-xcm(all,x))
velocity all set v_vx v_vy NULL
fix motion all nve
timestep {step}

# The wall: a V0 exp(-a y) on every point within 60/a.
variable push atom {force}*exp(-{a}*y)
region near block INF INF INF {reach} INF INF
group near dynamic all region near every 16
fix wall near addforce 0 v_push 0
compute force near reduce sum v_push

# What from_lammps reads.
variable x equal xcm(all,x)
variable y equal xcm(all,y)
variable u equal vcm(all,x)
variable v equal vcm(all,y)
variable angular_momentum equal angmom(all,z)
variable inertia equal inertia(all,zz)
compute kinetic all ke
fix force all ave/time 1 1 1 c_force file force.txt format " %.17g"
fix course all ave/time {look} 1 {look} v_x v_y v_u v_v v_angular_momentum v_inertia c_kinetic c_thermo_pe file motion.txt format " %.17g"

# Until the disk is back where it began and the wall is done with it.
variable left equal "v_v > 0 && v_y >= {height} && c_force/{a} <= {remaining}*v_v^2/2"
fix end all halt {look} v_left > 0 error soft
thermo {thermo}
thermo_style custom step cpu v_y v_v c_force
thermo_modify norm no
run {steps}
)";

constexpr double kGhosts = 1.51;       // times the longest bond; LAMMPS warns below 1.5
constexpr std::uint64_t kThermo = 10;  // looks between the lines on the screen

/// At the start, R.
double longest_bond(const Composition& composition) {
  const PointArray& position = composition.initial.position;
  double longest = 0.0;
  for (const Bond& bond : composition.bodies->disk().bonds) {
    const auto way = (position.row(bond.first) - position.row(bond.second)).matrix();
    longest = std::max(longest, way.norm());
  }
  return longest;
}

/// As many as Run would take before it gives up, in whole looks.
std::uint64_t most_steps(const Composition& composition) {
  const double steps = Run::kPatience * composition.expected_time / composition.resolution.step;
  return kLammpsLook * static_cast<std::uint64_t>(std::ceil(steps / kLammpsLook));
}

}  // namespace

Scene scene_for_lammps(Scene scene) {
  const IntegratorKind integrator = scene.numerics.integrator;
  const std::vector<std::tuple<const char*, bool, const char*>> demands{
      {"scene", scene.kind == SceneKind::kCollision, "collision"},
      {"wall.type", scene.wall.kind == WallKind::kPotential, "potential"},
      {"material.eta", scene.material.eta == 0.0, "0"},
      {"gravity", scene.gravity == 0.0, "0"},
      {"numerics.integrator",
       integrator == IntegratorKind::kAuto || integrator == IntegratorKind::kVerlet,
       "auto or verlet"}};
  for (const auto& [key, met, what] : demands) {
    if (met) continue;
    const FlatTree values = parse_keys(to_yaml(scene), "scene");
    throw bad_value(key, one_line(values.at(key)), fmt::format("{} in LAMMPS", what));
  }
  scene.numerics.integrator = IntegratorKind::kVerlet;
  return scene;
}

Composition compose_for_lammps(Scene scene) {
  scene.numerics.longest = std::numeric_limits<double>::infinity();
  return compose(scene, make_bodies(scene));
}

bool has_left(const Scene& scene, double rise, double velocity, double wall_energy) {
  return velocity > 0.0 && rise >= 0.0 &&
         wall_energy <= remaining_fraction(scene) * 0.5 * velocity * velocity;
}

std::string lammps_script(const Scene& scene, const Composition& composition) {
  const PointArray& position = composition.initial.position;
  const WallLaw wall = composition.field.wall->law();
  return fmt::format(
      kScript, fmt::arg("version", version()),
      fmt::arg("cutoff", kGhosts * longest_bond(composition)),
      fmt::arg("vx", scene.impact.tangential_velocity()),
      fmt::arg("vy", -scene.impact.normal_velocity()), fmt::arg("spin", scene.impact.spin),
      fmt::arg("step", composition.resolution.step), fmt::arg("a", wall.a),
      fmt::arg("force", wall.force_at_zero), fmt::arg("reach", wall.reach),
      fmt::arg("height", position.col(1).mean()), fmt::arg("remaining", remaining_fraction(scene)),
      fmt::arg("look", kLammpsLook), fmt::arg("thermo", kThermo * kLammpsLook),
      fmt::arg("steps", most_steps(composition)));
}

}  // namespace impact
