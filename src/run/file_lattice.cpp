#include "run/file_lattice.hpp"

#include <utility>

#include "lattice/lammps_data.hpp"
#include "lattice/rigidity.hpp"
#include "measure/flags.hpp"

namespace impact {

FileLattice lattice_of_file(const std::string& file) {
  LammpsLattice read = read_lammps_data(file);
  std::vector<std::string> flags;
  if (read.charged) flags.emplace_back(name_of(Flag::kChargeIgnored));
  if (is_floppy(read.lattice)) flags.emplace_back(name_of(Flag::kFloppy));
  return {std::move(read.lattice), std::move(flags)};
}

}  // namespace impact
