#include "lattice/lammps_data.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include "expect_input_error.hpp"
#include "lattice/lammps_writing.hpp"
#include "lattice/placement.hpp"

namespace impact {
namespace {

const char* const kTriangle = R"(a triangle

3 atoms
3 bonds
1 atom types
1 bond types

-2 2 xlo xhi
-3 3 ylo yhi
-0.5 0.5 zlo zhi

Masses

1 0.5

Atoms # molecular

3 1 1 0.5 1.0 0
1 1 1 0.0 0.0 0   # a comment
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

  Lattice read(const std::string& text) { return read_file(text).lattice; }

  LammpsLattice read_file(const std::string& text) {
    std::ofstream(path_) << text;
    return read_lammps_data(path_);
  }

  /// The triangle with the first `from` replaced.
  static std::string altered(const std::string& from, const std::string& to) {
    std::string text = kTriangle;
    return text.replace(text.find(from), from.size(), to);
  }

  std::string text_of_file() const {
    std::ifstream file(path_);
    return {std::istreambuf_iterator<char>(file), {}};
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
  const Lattice again = read_lammps_data(path_).lattice;
  EXPECT_TRUE((again.points == lattice.points).all());
  EXPECT_EQ(again.bonds, lattice.bonds);
  EXPECT_EQ(again.natural_lengths, lattice.natural_lengths);
}

TEST_F(LammpsData, NamesTheLineOfEachFault) {
  EXPECT_INPUT_ERROR(read(altered("2 1 1 1.0 0.0 0\n", "")), ":21: 2 atoms, the header says 3");
  EXPECT_INPUT_ERROR(read(altered("2 1 1 1.0 0.0 0\n", "1 1 1 1.0 0.0 0\n")), ":20: atom 1 again");
  EXPECT_INPUT_ERROR(read(altered("2 1 1 1.0", "4 1 1 1.0")),
                     ":24: atom 2 is not in the section Atoms");
  EXPECT_INPUT_ERROR(read(altered("1.0 0.0 0\n", "nan 0.0 0\n")), ":20: `nan` is not a finite");
  EXPECT_INPUT_ERROR(read(altered("1.0 0.0 0\n", "1,0 0.0 0\n")), ":20: `1,0` is not a finite");
  EXPECT_INPUT_ERROR(read(altered("1.0 0.0 0\n", "1.0 0.0 2\n")), ":20: z = 2, allowed 0");
  EXPECT_INPUT_ERROR(read(altered("1.0 0.0 0\n", "1.0 0.0\n")), ":20: expected `id molecule");
  EXPECT_INPUT_ERROR(read(altered("2 1 3 2", "2 1 3 3")), ":25: atom 3 is bonded to itself");
  EXPECT_INPUT_ERROR(read(altered("2 1 3 2", "2 1 3 9")),
                     ":25: atom 9 is not in the section Atoms");
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

/// What would change the motion is followed or refused, never passed over.
TEST_F(LammpsData, RefusesWhatItDoesNotFollow) {
  const std::string other_type = altered("2 1 1 1.0", "2 1 2 1.0");
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_INPUT_ERROR(read(with(other_type, "1 0.5", "1 0.5\n2 0.7")),
                     ":15: mass 0.7 beside 0.5: all points have the same mass");
  EXPECT_INPUT_ERROR(read(other_type), ":20: type 2 has no mass");
  EXPECT_INPUT_ERROR(read(altered("2 1 3 2", "2 2 3 2")), ":25: bond type 2 beside 1");
  EXPECT_INPUT_ERROR(read(altered("Masses", "Bond Coeffs # harmonic\n\n1 0.5 1.0\n\nMasses")),
                     ":12: section Bond Coeffs: what it says is not followed here");
  EXPECT_INPUT_ERROR(read(kTriangle + std::string("\nVelocities\n\n1 0 0.1 0\n")),
                     ":30: section Velocities");
  EXPECT_INPUT_ERROR(read(kTriangle + std::string("\nAngles\n\n1 1 1 2 3\n")),
                     ":28: section Angles");
  EXPECT_INPUT_ERROR(read(altered("1 atom types", "4 angles")), ":5: number of angles `4`");
  EXPECT_INPUT_ERROR(read(kTriangle + std::string("\nAtoms\n\n1 1 1 0 0 0\n")),
                     ":28: section Atoms again");
  EXPECT_INPUT_ERROR(read(altered("2 1 3 2", "1 1 3 2")), ":25: bond 1 again");
  EXPECT_INPUT_ERROR(read(altered("-0.5 0.5 zlo", "0.1 0 0 xy xz yz\n-0.5 0.5 zlo")),
                     ":10: a tilted box");
  EXPECT_INPUT_ERROR(read(altered("# molecular", "# atomic")), ":16: atom style atomic");
  EXPECT_INPUT_ERROR(read(altered("# molecular", "# sphere")), ":16: atom style sphere");
  EXPECT_NO_THROW(read(kTriangle + std::string("\nVelocities\n\n1 0 0 0\n2 0 0 0\n3 0 0 0\n")));
}

TEST_F(LammpsData, RefusesAFileThatIsCut) {
  const std::string whole(kTriangle);
  for (std::size_t cut = 1; cut < whole.size(); ++cut) {
    EXPECT_THROW(read(whole.substr(0, whole.size() - cut)), InputError) << cut << " bytes";
  }
}

TEST_F(LammpsData, TakesAnyIds) {
  std::string text = kTriangle;
  for (const auto& [from, to] : {std::pair{"3 1 1 0.5", "900 1 1 0.5"},
                                 {"2 1 3 2", "17 1 900 2"},
                                 {"3 1 1 3", "9000000000 1 1 900"}}) {
    text.replace(text.find(from), std::string(from).size(), to);
  }
  const Lattice lattice = read(text);
  EXPECT_TRUE((lattice.points == read(kTriangle).points).all());
  EXPECT_EQ(lattice.bonds, read(kTriangle).bonds);
}

TEST_F(LammpsData, ReadsTheStylesWithBonds) {
  const Lattice expected = read(kTriangle);
  for (const char* hint : {"# bond", ""}) {
    EXPECT_TRUE((read(altered("# molecular", hint)).points == expected.points).all());
  }
  for (const std::string hint : {"# full", ""}) {
    std::string text = altered("# molecular", hint);
    for (const char* atom : {"3 1 1 ", "1 1 1 0.0", "2 1 1 "}) {
      text.insert(text.find(atom, text.find("Atoms")) + 6, "0.1 ");
    }
    const LammpsLattice file = read_file(text);
    EXPECT_TRUE((file.lattice.points == expected.points).all());
    EXPECT_TRUE(file.charged);
  }
  EXPECT_FALSE(read_file(kTriangle).charged);
}

/// The triangle moved over the right edge of its box, by image flags, by the nearest image, and
/// with a bond that no image makes short.
TEST_F(LammpsData, MakesBondsOverTheEdgeOfTheBoxWhole) {
  const Lattice expected = read(kTriangle);
  EXPECT_EQ(read(altered("1.0 0.0 0\n", "-3.0 0.0 0 1 0 0\n")).natural_lengths,
            expected.natural_lengths);
  EXPECT_EQ(read(altered("1.0 0.0 0\n", "-3.0 6.0 0\n")).natural_lengths, expected.natural_lengths);
  EXPECT_INPUT_ERROR(read(altered("-2 2 xlo", "0 1.5 xlo")),
                     ":25: the bond of atoms 2 and 3 is longer than half of the box");
  EXPECT_INPUT_ERROR(read(altered("1.0 0.0 0\n", "-3.0 0.0 0 1 0\n")), "three image flags");
  EXPECT_INPUT_ERROR(read(altered("1.0 0.0 0\n", "-3.0 0.0 0 1 0 1\n")), ":20: image flag `1`");
}

/// A bond of just half of the box is not taken for one over its edge.
TEST_F(LammpsData, LeavesABondOfHalfOfTheBoxWhereItIs) {
  EXPECT_EQ(read(altered("-2 2 xlo", "0 2 xlo")).natural_lengths, read(kTriangle).natural_lengths);
}

TEST_F(LammpsData, ReadsWhatGzipHasPacked) {
  const Lattice expected = read(kTriangle);
  gzFile file = gzopen(path_.c_str(), "wb");
  gzputs(file, kTriangle);
  gzclose(file);
  EXPECT_TRUE((read_lammps_data(path_).lattice.points == expected.points).all());
  std::filesystem::resize_file(path_, std::filesystem::file_size(path_) - 10);
  EXPECT_INPUT_ERROR(read_lammps_data(path_), "cannot be read");
}

/// Where the disk is, in a box 0.1 R wider, each bond of its own type.
TEST_F(LammpsData, WritesADiskAtItsStart) {
  const Lattice lattice = read(kTriangle);
  write_lammps_start(lattice, 2.0 * lattice.points, 0.25, path_);
  const std::string text = text_of_file();
  for (const char* const part : {"\n3 atoms\n3 bonds\n1 atom types\n3 bond types\n",
                                 "\n-0.1 2.1 xlo xhi\n-0.1 2.1 ylo yhi\n", "\nMasses\n\n1 0.25\n",
                                 "\nAtoms # bond\n\n1 1 1 0 0 0\n2 1 1 2 0 0\n3 1 1 1 2 0\n",
                                 "\nBonds\n\n1 1 1 2\n2 2 1 3\n3 3 2 3\n"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
}

/// E = K₂ x² + K₃ x³ + K₄ x⁴ is k_a x²/2 + k_b x⁴/4.
TEST_F(LammpsData, WritesTheLawOfEachBond) {
  write_lammps_bonds({1.0, 0.1 + 0.2}, 3.0, 0.5, path_);
  EXPECT_EQ(text_of_file(),
            "bond_coeff 1 1 1.5 0 0.125\nbond_coeff 2 0.30000000000000004 1.5 0 0.125\n");
}

TEST_F(LammpsData, SaysWhenItCannotWrite) {
  const Lattice lattice = read(kTriangle);
  EXPECT_INPUT_ERROR(write_lammps_bonds({1.0}, 1.0, 0.0, "/dev/full"), "cannot be written");
  EXPECT_INPUT_ERROR(write_lammps_data(lattice, 1.0, "/nowhere/file.data"), "cannot be written");
}

}  // namespace
}  // namespace impact
