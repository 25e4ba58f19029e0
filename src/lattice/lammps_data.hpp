#pragma once

#include <filesystem>

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

}  // namespace impact
