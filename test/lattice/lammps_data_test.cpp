#include "lattice/lammps_data.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "expect_input_error.hpp"
#include "lattice/placement.hpp"

namespace impact {
namespace {

const char* const kTriangle = R"(a triangle

3 atoms
3 bonds
1 atom types
1 bond types

0 1 xlo xhi
0 1 ylo yhi
-0.5 0.5 zlo zhi

Masses

1 0.5

Atoms # molecular

3 1 1 0.5 1.0 0
1 1 1 0.0 0.0 0 0 0 0   # image flags and a comment
2 1 1 1.0 0.0 0

Bonds

1 1 1 2
2 1 3 2
3 1 1 3
)";

class LammpsData : public testing::Test {
 protected:
  void SetUp() override {
    path_ = std::filesystem::path(testing::TempDir()) / "lammps_data_test.data";
  }
  void TearDown() override { std::filesystem::remove(path_); }

  Lattice read(const std::string& text) {
    std::ofstream(path_) << text;
    return read_lammps_data(path_);
  }

  /// The triangle with the first `from` replaced.
  static std::string altered(const std::string& from, const std::string& to) {
    std::string text = kTriangle;
    return text.replace(text.find(from), from.size(), to);
  }

  std::filesystem::path path_;
};

TEST_F(LammpsData, ReadsAtomsInTheOrderOfTheirIds) {
  const Lattice lattice = read(kTriangle);
  PointArray expected(3, 2);
  expected << 0, 0, 1, 0, 0.5, 1;
  EXPECT_TRUE((lattice.points == expected).all());
  const std::vector<Bond> bonds{{0, 1}, {0, 2}, {1, 2}};
  EXPECT_EQ(lattice.bonds, bonds);
}

TEST_F(LammpsData, RoundTripKeepsEveryBit) {
  const Lattice lattice = triangulated_lattice(place_in_disk({}, 11));
  write_lammps_data(lattice, 1.0 / 1099, path_);
  const Lattice again = read_lammps_data(path_);
  EXPECT_TRUE((again.points == lattice.points).all());
  EXPECT_EQ(again.bonds, lattice.bonds);
  EXPECT_EQ(again.natural_lengths, lattice.natural_lengths);
}

TEST_F(LammpsData, NamesTheLineOfEachFault) {
  EXPECT_INPUT_ERROR(read(altered("2 1 1 1.0 0.0 0\n", "")), ":21: atom 2 is missing");
  EXPECT_INPUT_ERROR(read(altered("2 1 1 1.0 0.0 0\n", "1 1 1 1.0 0.0 0\n")), ":20: atom 1 again");
  EXPECT_INPUT_ERROR(read(altered("2 1 1 1.0", "4 1 1 1.0")), ":20: atom `4`, allowed 1 … 3");
  EXPECT_INPUT_ERROR(read(altered("1.0 0.0 0\n", "nan 0.0 0\n")), ":20: `nan` is not a finite");
  EXPECT_INPUT_ERROR(read(altered("1.0 0.0 0\n", "1,0 0.0 0\n")), ":20: `1,0` is not a finite");
  EXPECT_INPUT_ERROR(read(altered("1.0 0.0 0\n", "1.0 0.0 2\n")), ":20: z = 2, allowed 0");
  EXPECT_INPUT_ERROR(read(altered("1.0 0.0 0\n", "1.0 0.0\n")), ":20: expected `id molecule");
  EXPECT_INPUT_ERROR(read(altered("0 0 0 0  ", "0 1 0 0  ")), ":19: image flag");
  EXPECT_INPUT_ERROR(read(altered("2 1 3 2", "2 1 3 3")), ":25: atom 3 is bonded to itself");
  EXPECT_INPUT_ERROR(read(altered("2 1 3 2", "2 1 3 9")), ":25: atom `9`, allowed 1 … 3");
  EXPECT_INPUT_ERROR(read(altered("2 1 1 1.0", "2 1 1 0.0")), ":20: atoms 1 and 2 coincide");
  EXPECT_INPUT_ERROR(read(altered("3 bonds", "4 bonds")), "3 bonds, the header says 4");
  EXPECT_INPUT_ERROR(read(altered("3 atoms", "2 atoms")), ":3: number of atoms `2`, allowed 3");
  EXPECT_INPUT_ERROR(read(altered("3 atoms\n", "")), "no line `N atoms`");
  EXPECT_INPUT_ERROR(read(altered("2 1 3 2", "2 1 1 2")), ":25: atoms 1 and 2 are bonded twice");
  EXPECT_INPUT_ERROR(read(altered("3 bonds\n", "")), "no line `N bonds`");
  EXPECT_INPUT_ERROR(read(altered("3 atoms", "2000000 atoms")), "allowed 3 … 1000000");
  EXPECT_INPUT_ERROR(read("title\n"), "no section Atoms");
  EXPECT_INPUT_ERROR(read_lammps_data("/nowhere/file.data"), "cannot be read");
}

TEST_F(LammpsData, SaysWhenItCannotWrite) {
  const Lattice lattice = read(kTriangle);
  EXPECT_INPUT_ERROR(write_lammps_data(lattice, 1.0, "/nowhere/file.data"), "cannot be written");
}

}  // namespace
}  // namespace impact
