#pragma once

#include <string>
#include <vector>

#include "lattice/lattice.hpp"

namespace impact {

/// A lattice from a file, and what a reader of its runs should know.
struct FileLattice {
  Lattice lattice;
  std::vector<std::string> flags;  ///< of Run::flags(): charge_ignored, floppy
};

/// @throw InputError as read_lammps_data().
FileLattice lattice_of_file(const std::string& file);

}  // namespace impact
