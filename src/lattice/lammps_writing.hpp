#pragma once

#include <filesystem>
#include <vector>

#include "lattice/lattice.hpp"

namespace impact {

/// Writes the lattice so that read_lammps_data() gives the same bits. `mass` is that of one point,
/// in M.
/// @throw InputError when the file cannot be written.
void write_lammps_data(const Lattice& lattice, double mass, const std::filesystem::path& path);

/// Writes a disk as it is at the start of a motion in LAMMPS (`atom_style bond`): its points at
/// `position`, each bond of a type of its own, in their order.
/// @throw InputError when the file cannot be written.
void write_lammps_start(const Lattice& lattice, const PointArray& position, double mass,
                        const std::filesystem::path& path);

/// Writes the commands `bond_coeff` of the style `class2`, K2 = k_a/2, K3 = 0, K4 = k_b/4, which
/// give bond type k the natural length number k. (The section Bond Coeffs of a data file takes 8
/// million types at most.)
/// @throw InputError when the file cannot be written.
void write_lammps_bonds(const std::vector<double>& natural_lengths, double k_a, double k_b,
                        const std::filesystem::path& path);

}  // namespace impact
