#include "lattice/lammps_writing.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <cstddef>
#include <fstream>
#include <ostream>

#include "lattice/input_error.hpp"

namespace impact {
namespace {

/// Writes a file part by part, so that the text of the whole is never in memory.
template <class Print>
void write_file(const std::filesystem::path& path, const Print& print) {
  std::ofstream file(path, std::ios::binary);
  print(file);
  if (!file.flush()) throw InputError(fmt::format("{}: cannot be written", path.string()));
}

using Size = Eigen::Array<double, 1, 2>;

Size size_of(const PointArray& points) {
  return points.colwise().maxCoeff() - points.colwise().minCoeff();
}

/// What a data file says.
struct Content {
  const char* title;
  const char* atom_style;
  const PointArray& points;
  const std::vector<Bond>& bonds;
  double mass;
  Size margin;  ///< of the box around the points, R
  /// 1: all bonds are of one type; as many as there are bonds: each is of its own.
  std::size_t bond_types = 1;
};

void print_header(const Content& content, std::ostream& out) {
  const Size low = content.points.colwise().minCoeff() - content.margin;
  const Size high = content.points.colwise().maxCoeff() + content.margin;
  fmt::print(out, "{}\n\n{} atoms\n{} bonds\n1 atom types\n{} bond types\n\n", content.title,
             content.points.rows(), content.bonds.size(), content.bond_types);
  fmt::print(out, "{} {} xlo xhi\n{} {} ylo yhi\n-0.5 0.5 zlo zhi\n\n", low(0), high(0), low(1),
             high(1));
  fmt::print(out, "Masses\n\n1 {}\n\n", content.mass);
}

void print_atoms(const Content& content, std::ostream& out) {
  const PointArray& points = content.points;
  fmt::print(out, "Atoms # {}\n\n", content.atom_style);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    fmt::print(out, "{} 1 1 {} {} 0\n", i + 1, points(i, 0), points(i, 1));
  }
}

void print_bonds(const Content& content, std::ostream& out) {
  const std::vector<Bond>& bonds = content.bonds;
  fmt::print(out, "\nBonds\n\n");
  for (std::size_t k = 0; k < bonds.size(); ++k) {
    fmt::print(out, "{} {} {} {}\n", k + 1, content.bond_types == 1 ? 1 : k + 1, bonds[k].first + 1,
               bonds[k].second + 1);
  }
}

void write(const Content& content, const std::filesystem::path& path) {
  write_file(path, [&](std::ostream& out) {
    print_header(content, out);
    print_atoms(content, out);
    print_bonds(content, out);
  });
}

}  // namespace

void write_lammps_data(const Lattice& lattice, double mass, const std::filesystem::path& path) {
  // Three times as wide and high as the lattice, so that no bond can be taken for one over the
  // box's edge.
  write({"lattice, lengths in R, masses in M", "molecular", lattice.points, lattice.bonds, mass,
         size_of(lattice.points)},
        path);
}

void write_lammps_start(const Lattice& lattice, const PointArray& position, double mass,
                        const std::filesystem::path& path) {
  constexpr double kMargin = 0.1;  // R
  write({"a disk at its start, lengths in R, masses in M",
         "bond",
         position,
         lattice.bonds,
         mass,
         {kMargin, kMargin},
         lattice.bonds.size()},
        path);
}

void write_lammps_bonds(const std::vector<double>& natural_lengths, double k_a, double k_b,
                        const std::filesystem::path& path) {
  write_file(path, [&](std::ostream& out) {
    for (std::size_t k = 0; k < natural_lengths.size(); ++k) {
      fmt::print(out, "bond_coeff {} {} {} 0 {}\n", k + 1, natural_lengths[k], k_a / 2.0,
                 k_b / 4.0);
    }
  });
}

}  // namespace impact
