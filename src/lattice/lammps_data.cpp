#include "lattice/lammps_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "lattice/input_error.hpp"

namespace impact {
namespace {

/// Reads line by line, without comments, and knows where it stands.
class LineReader {
 public:
  explicit LineReader(const std::filesystem::path& path) : path_(path), stream_(path) {
    if (!stream_) throw InputError(fmt::format("{}: cannot be read", path_.string()));
    std::string title;
    std::getline(stream_, title);
  }

  /// Goes to the next line that has any words; false at the end of the file.
  bool next() {
    words_.clear();
    while (words_.empty() && std::getline(stream_, line_)) {
      ++number_;
      split();
    }
    return !words_.empty();
  }

  /// Each ends in the line at a character that belongs to no number.
  const std::vector<std::string_view>& words() const { return words_; }

  int number() const { return number_; }

  [[noreturn]] void fail(const std::string& what) const { fail_at(number_, what); }

  [[noreturn]] void fail_at(int number, const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", path_.string(), number, what));
  }

  void require_columns(std::size_t low, std::size_t high, const char* form) const {
    if (words_.size() < low || words_.size() > high) {
      fail(fmt::format("expected `{}`, got {} columns", form, words_.size()));
    }
  }

  double real(std::size_t column) const {
    const std::string_view word = words_[column];
    char* end = nullptr;
    const double value = std::strtod(word.data(), &end);
    if (end != word.data() + word.size() || !std::isfinite(value)) {
      fail(fmt::format("`{}` is not a finite number", word));
    }
    return value;
  }

  /// The whole number in this column, `low` … `high`; `what` names it in an error.
  std::int32_t whole(std::size_t column, std::int64_t low, std::int64_t high,
                     const char* what) const {
    const std::string_view word = words_[column];
    char* end = nullptr;
    const long long value = std::strtoll(word.data(), &end, 10);
    if (end != word.data() + word.size() || value < low || value > high) {
      fail(fmt::format("{} `{}`, allowed {} … {}", what, word, low, high));
    }
    return static_cast<std::int32_t>(value);
  }

 private:
  void split() {
    constexpr const char* kBlanks = " \t\r\v\f";
    const std::string_view text = std::string_view(line_).substr(0, line_.find('#'));
    std::size_t end = 0;
    for (std::size_t begin = text.find_first_not_of(kBlanks); begin != std::string_view::npos;
         begin = text.find_first_not_of(kBlanks, end)) {
      end = std::min(text.find_first_of(kBlanks, begin), text.size());
      words_.push_back(text.substr(begin, end - begin));
    }
  }

  std::filesystem::path path_;
  std::ifstream stream_;
  std::string line_;
  std::vector<std::string_view> words_;  ///< of the line
  int number_ = 1;
};

/// What the file says, filled in line by line.
class DataFile {
 public:
  explicit DataFile(const std::filesystem::path& path) : reader_(path) {
    std::string section;
    while (reader_.next()) {
      const std::string_view word = reader_.words().front();
      if (std::isalpha(static_cast<unsigned char>(word.front())) != 0) {
        finish(section);
        section = reader_.words().size() == 1 ? std::string(word) : "other";
        begin(section);
      } else if (section.empty()) {
        read_header_line();
      } else if (section == "Atoms") {
        read_atom();
      } else if (section == "Bonds") {
        read_bond();
      }
    }
    finish(section);
    if (points_.rows() == 0) reader_.fail("the file has no section Atoms");
    if (bonds_.empty()) reader_.fail("the file has no section Bonds");
  }

  Lattice lattice() && { return make_lattice(std::move(points_), std::move(bonds_)); }

 private:
  static constexpr std::int32_t kMostAtoms = 1000000;
  static constexpr std::int32_t kMostBonds = 100000000;

  void begin(const std::string& section) {
    if (section == "Atoms") {
      if (atom_count_ < 0) reader_.fail("no line `N atoms` before the section Atoms");
      points_.setConstant(atom_count_, 2, std::numeric_limits<double>::quiet_NaN());
      atom_lines_.resize(static_cast<std::size_t>(atom_count_));
    }
    if (section == "Bonds" && bond_count_ < 0) {
      reader_.fail("no line `N bonds` before the section Bonds");
    }
    if (section == "Bonds" && points_.rows() == 0) {
      reader_.fail("the section Bonds comes before the section Atoms");
    }
  }

  void finish(const std::string& section) const {
    if (section == "Atoms") {
      for (Eigen::Index i = 0; i < points_.rows(); ++i) {
        if (std::isnan(points_(i, 0))) reader_.fail(fmt::format("atom {} is missing", i + 1));
      }
      require_distinct_atoms();
    }
    if (section == "Bonds") {
      if (static_cast<std::int64_t>(bonds_.size()) != bond_count_) {
        reader_.fail(fmt::format("{} bonds, the header says {}", bonds_.size(), bond_count_));
      }
      require_distinct_bonds();
    }
  }

  void require_distinct_atoms() const {
    const auto place = [this](std::int32_t i) {
      return std::make_pair(points_(i, 0), points_(i, 1));
    };
    const auto same = first_pair(
        atom_lines_.size(), [&](auto a, auto b) { return place(a) < place(b); },
        [&](auto a, auto b) { return place(a) == place(b); });
    if (!same) return;
    reader_.fail_at(std::max(line(atom_lines_, same->first), line(atom_lines_, same->second)),
                    fmt::format("atoms {} and {} coincide", same->first + 1, same->second + 1));
  }

  void require_distinct_bonds() const {
    const auto bond = [this](std::int32_t k) { return bonds_[static_cast<std::size_t>(k)]; };
    const auto same = first_pair(
        bonds_.size(), [&](auto a, auto b) { return bond(a) < bond(b); },
        [&](auto a, auto b) { return bond(a) == bond(b); });
    if (!same) return;
    reader_.fail_at(std::max(line(bond_lines_, same->first), line(bond_lines_, same->second)),
                    fmt::format("atoms {} and {} are bonded twice", bond(same->first).first + 1,
                                bond(same->first).second + 1));
  }

  static int line(const std::vector<int>& lines, std::int32_t place) {
    return lines[static_cast<std::size_t>(place)];
  }

  /// Two of the places 0 … count − 1 that are equal; the lower first.
  template <class Less, class Equal>
  static std::optional<std::pair<std::int32_t, std::int32_t>> first_pair(std::size_t count,
                                                                         const Less& less,
                                                                         const Equal& equal) {
    std::vector<std::int32_t> places(count);
    std::iota(places.begin(), places.end(), 0);
    std::sort(places.begin(), places.end(), less);
    const auto same = std::adjacent_find(places.begin(), places.end(), equal);
    if (same == places.end()) return std::nullopt;
    return std::minmax(*same, *std::next(same));
  }

  void read_header_line() {
    if (reader_.words().size() != 2) return;
    if (reader_.words()[1] == "atoms") {
      atom_count_ = reader_.whole(0, 3, kMostAtoms, "number of atoms");
    } else if (reader_.words()[1] == "bonds") {
      bond_count_ = reader_.whole(0, 2, kMostBonds, "number of bonds");
    }
  }

  void read_atom() {
    reader_.require_columns(6, 9, "id molecule type x y z");
    const std::int32_t index = reader_.whole(0, 1, points_.rows(), "atom") - 1;
    if (!std::isnan(points_(index, 0))) reader_.fail(fmt::format("atom {} again", index + 1));
    if (reader_.real(5) != 0.0) reader_.fail(fmt::format("z = {}, allowed 0", reader_.words()[5]));
    for (std::size_t flag = 6; flag < reader_.words().size(); ++flag) {
      reader_.whole(flag, 0, 0, "image flag (positions must be unwrapped)");
    }
    points_.row(index) << reader_.real(3), reader_.real(4);
    atom_lines_[static_cast<std::size_t>(index)] = reader_.number();
  }

  void read_bond() {
    reader_.require_columns(4, 4, "id type atom atom");
    const std::int32_t a = reader_.whole(2, 1, points_.rows(), "atom") - 1;
    const std::int32_t b = reader_.whole(3, 1, points_.rows(), "atom") - 1;
    if (a == b) reader_.fail(fmt::format("atom {} is bonded to itself", a + 1));
    bonds_.push_back({std::min(a, b), std::max(a, b)});
    bond_lines_.push_back(reader_.number());
  }

  LineReader reader_;
  std::int32_t atom_count_ = -1;
  std::int64_t bond_count_ = -1;
  PointArray points_;
  std::vector<Bond> bonds_;
  std::vector<int> atom_lines_;  ///< in the file
  std::vector<int> bond_lines_;
};

}  // namespace

Lattice read_lammps_data(const std::filesystem::path& path) {
  DataFile file(path);
  try {
    return std::move(file).lattice();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

void write_lammps_data(const Lattice& lattice, double mass, const std::filesystem::path& path) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  const auto low = lattice.points.colwise().minCoeff().eval();
  const auto high = lattice.points.colwise().maxCoeff().eval();
  fmt::format_to(out, "lattice, lengths in R, masses in M\n\n{} atoms\n{} bonds\n",
                 lattice.points.rows(), lattice.bonds.size());
  fmt::format_to(out, "1 atom types\n1 bond types\n\n{} {} xlo xhi\n{} {} ylo yhi\n", low(0),
                 high(0), low(1), high(1));
  fmt::format_to(out, "-0.5 0.5 zlo zhi\n\nMasses\n\n1 {}\n\nAtoms # molecular\n\n", mass);
  for (Eigen::Index i = 0; i < lattice.points.rows(); ++i) {
    fmt::format_to(out, "{} 1 1 {} {} 0\n", i + 1, lattice.points(i, 0), lattice.points(i, 1));
  }
  fmt::format_to(out, "\nBonds\n\n");
  for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
    fmt::format_to(out, "{} 1 {} {}\n", k + 1, lattice.bonds[k].first + 1,
                   lattice.bonds[k].second + 1);
  }
  std::ofstream file(path, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file.flush()) throw InputError(fmt::format("{}: cannot be written", path.string()));
}

}  // namespace impact
