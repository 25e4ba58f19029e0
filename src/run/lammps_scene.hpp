#pragma once

#include <cstdint>
#include <string>

#include "run/compose.hpp"

/// An impact for LAMMPS, which moves a lattice on many machines.
namespace impact {

/// The scene as LAMMPS runs it: by velocity Verlet.
/// @throw InputError for what LAMMPS cannot express, naming the key: scenes other than a collision
/// with the potential wall, damping, gravity and other integrators.
Scene scene_for_lammps(Scene scene);

/// The composition of such a scene, for which numerics.longest and the size that one machine can
/// simulate do not count. The resolution is that of the run.
/// @throw InputError as compose().
Composition compose_for_lammps(Scene scene);

/// Steps between the rows of motion.txt, and between looks whether the disk has left.
constexpr std::uint64_t kLammpsLook = 100;

/// Whether an impact counts as over for LAMMPS, which can prove nothing about the flight after it:
/// the centre of mass rises, is as high as at the start, and the wall holds no more than
/// remaining_fraction() of the energy of its motion.
/// `rise` is that above the height at the start (R), `velocity` that along y (c), `wall_energy` in
/// M c².
bool has_left(const Scene& scene, double rise, double velocity, double wall_energy);

/// The input script. LAMMPS reads start.data and bonds.in beside it, and writes force.txt, the
/// force of the wall at every step, and motion.txt, the motion and energies of the disk every
/// kLammpsLook steps, until has_left() or until Run would have given up.
std::string lammps_script(const Scene& scene, const Composition& composition);

}  // namespace impact
