#include "run/compose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lattice/input_error.hpp"
#include "lattice/lammps_data.hpp"
#include "lattice/placement.hpp"
#include "run/step_choice.hpp"

namespace impact {
namespace {

/// E of the triangular lattice, 2/√3 k_a, and the density M/(πR²): close to what random lattices
/// have (physics: 1.04 … 1.1 k_a).
double estimated_sound_speed(double k_a) { return std::sqrt(2.0 / std::sqrt(3.0) * k_a * M_PI); }

Lattice disk_lattice(const Scene& scene) {
  if (!scene.disk.file.empty()) {
    try {
      return read_lammps_data(scene.disk.file);
    } catch (const InputError& error) {
      throw InputError(fmt::format("disk.file: {}", error.what()));
    }
  }
  return triangulated_lattice(place_in_disk(scene.disk.recipe, scene.seed));
}

State initial_state(const Scene& scene, const PointArray& reference, const PotentialWall& wall) {
  State state;
  state.position = reference;
  state.velocity = PointArray::Zero(reference.rows(), 2);
  double lowest = 0.0;
  if (scene.kind == SceneKind::kContact) {
    lowest = wall.height_of_force(scene.load.p);
  } else {
    lowest = scene.impact.gap ? *scene.impact.gap
                              : wall.height_of_energy(reference, negligible_wall_energy(scene));
    state.velocity.col(1) = -scene.impact.velocity;
  }
  state.position.col(1) += lowest - reference.col(1).minCoeff();
  return state;
}

/// Rough time until the disk's bouncing on the wall has decayed to the wanted error. The disk is
/// the spring k_d = dP/dξ ≈ πE/(ln(4πER/P) − 2) of the 2D Hertz contact with Kelvin–Voigt damping
/// of the time constant η/k_a, in series with the wall's own undamped spring k_w = a P. So the
/// bouncing decays at the rate (η/k_a) k_d (k_w/(k_w + k_d))²/(2M), or k_a/η when overdamped.
double relaxation_time(const Scene& scene, double sound_speed, int points) {
  const double time_constant = scene.material.eta / (points * scene.material.k_a);
  const double pi_e = sound_speed * sound_speed;
  const double disk = pi_e / std::max(1.0, std::log(4.0 * pi_e / scene.load.p) - 2.0);
  const double wall = scene.wall.a * scene.load.p;
  const double share = wall / (wall + disk);
  const double rate = std::min(0.5 * time_constant * disk * share * share, 1.0 / time_constant);
  return std::log(10.0 / scene.numerics.error) / rate;
}

double impact_time(const Scene& scene, double sound_speed, double gap) {
  const double v = scene.impact.velocity;
  const double contact =
      M_PI / sound_speed * std::sqrt(std::max(1.0, std::log(4.0 * sound_speed / v)));
  return 2.0 * std::max(0.0, gap) / v + contact;
}

}  // namespace

double negligible_wall_energy(const Scene& scene) {
  return 0.01 * scene.numerics.error * 0.5 * scene.impact.velocity * scene.impact.velocity;
}

Composition compose(const Scene& scene) {
  Lattice lattice = disk_lattice(scene);
  const auto points = static_cast<int>(lattice.points.rows());
  const double mass = 1.0 / points;
  const BondLaw law{scene.material.k_a, scene.material.k_b, scene.material.eta * mass};
  const Spectrum spectrum = lattice_spectrum(lattice, law, mass);
  const double sound_speed = estimated_sound_speed(law.k_a);
  const PotentialWall wall(scene.wall.a, scene.wall.v0.value_or(scene.wall.a * mass));
  State initial = initial_state(scene, lattice.points, wall);

  ForceField field{BondForces(lattice, law), mass};
  field.wall = wall;
  double expected_time = 0.0;
  if (scene.kind == SceneKind::kContact) {
    field.load.emplace(scene.load.p);
    if (scene.load.hold_rotation) field.hold.emplace(lattice.points);
    if (scene.numerics.integrator != IntegratorKind::kNewton) {
      expected_time = relaxation_time(scene, sound_speed, points);
    }
  } else {
    expected_time = impact_time(scene, sound_speed, initial.position.col(1).minCoeff());
  }
  const double step = choose_step(scene, spectrum, wall, points, sound_speed);
  return {std::move(lattice), std::move(field), std::move(initial), spectrum, step,
          sound_speed,        expected_time};
}

}  // namespace impact
