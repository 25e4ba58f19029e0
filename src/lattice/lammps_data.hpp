#pragma once

#include <filesystem>

#include "lattice/lattice.hpp"

namespace impact {

/// Reads a lattice from a LAMMPS data file (docs.lammps.org/read_data.html) of atom style
/// `molecular`: header counts, section Atoms as `id molecule type x y z`, section Bonds as
/// `id type atom atom`. Lengths in R. Points keep the order of their ids; a bond's natural length
/// is its length in the file. Other sections, types and masses are passed over.
/// @throw InputError with file and line number when the file cannot be read or is not such a
/// lattice: a missing, repeated or unknown atom, a number that is none or not finite, z ≠ 0, a
/// bond to itself, a count that does not agree; and as make_lattice().
Lattice read_lammps_data(const std::filesystem::path& path);

/// Writes the lattice so that read_lammps_data() gives the same bits. `mass` is that of one point,
/// in M.
/// @throw InputError when the file cannot be written.
void write_lammps_data(const Lattice& lattice, double mass, const std::filesystem::path& path);

}  // namespace impact
