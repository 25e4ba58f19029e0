// Any bytes as a lattice file: a lattice with the parts that it must have, or one line of error.

#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>

#include "input.hpp"
#include "lattice/lammps_data.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const int file = memfd_create("lattice.data", 0);
  static const std::string path = "/proc/self/fd/" + std::to_string(file);
  if (ftruncate(file, 0) != 0 || pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) {
    std::abort();
  }
  impact::must_be_one_line([&] {
    const impact::Lattice lattice = impact::read_lammps_data(path).lattice;
    const auto points = static_cast<std::size_t>(lattice.points.rows());
    if (points < 2 || !lattice.points.allFinite()) std::abort();
    for (const auto& [first, second] : lattice.bonds) {
      if (static_cast<std::size_t>(first) >= points || static_cast<std::size_t>(second) >= points) {
        std::abort();
      }
    }
  });
  return 0;
}
