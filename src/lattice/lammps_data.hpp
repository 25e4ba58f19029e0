#pragma once

#include <filesystem>
#include <vector>

#include "lattice/lattice.hpp"

namespace impact {

/// What a LAMMPS data file says of a lattice.
struct LammpsLattice {
  Lattice lattice;
  bool charged = false;  ///< atoms have charges, which have no effect here
};

/// Reads a lattice from a LAMMPS data file (docs.lammps.org/read_data.html), plain or packed by
/// gzip, of atom style `bond`, `molecular` or `full`: header counts and box, section Atoms, section
/// Bonds as `id type atom atom`. Lengths in R. Points keep the order of their ids, which may have
/// gaps; a bond's natural length is its length in the file. Bonds over the edge of a periodic box
/// are made whole by the image flags, where there are any, else by the nearest image.
/// @throw InputError with file and line number when the file cannot be read or is not such a
/// lattice: a missing, repeated or unknown atom or bond, a number that is none or not finite, z ≠
/// 0, a bond to itself or longer than half of the box, a count that does not agree, a last line
/// without end; when it says what is not followed here: masses or types of bonds that differ,
/// velocities, coefficients, angles and whatever else has a section; and as make_lattice().
LammpsLattice read_lammps_data(const std::filesystem::path& path);

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
