#include "lattice/lammps_data.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "lattice/input_error.hpp"

namespace impact {
namespace {

constexpr std::int32_t kMostAtoms = 1000000;
constexpr std::int32_t kMostBonds = 100000000;
constexpr std::int64_t kLargestId = std::numeric_limits<std::int64_t>::max();

/// The bytes of a file, or those that are packed in it by gzip.
std::string content(const std::filesystem::path& path) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), &gzclose);
  if (file == nullptr) throw InputError(fmt::format("{}: cannot be read", path.string()));
  constexpr std::size_t kMostBytes = std::size_t{1} << 32U;
  std::string text;
  std::array<char, 1U << 16U> part{};
  int read = 0;
  while ((read = gzread(file.get(), part.data(), part.size())) > 0 && text.size() < kMostBytes) {
    text.append(part.data(), static_cast<std::size_t>(read));
  }
  int error = Z_OK;
  const char* cause = gzerror(file.get(), &error);
  if (error != Z_OK || text.size() >= kMostBytes) {
    throw InputError(fmt::format("{}: cannot be read: {}", path.string(),
                                 error == Z_ERRNO ? "it is no file" : cause));
  }
  return text;
}

/// Reads line by line, without comments, and knows where it stands.
class LineReader {
 public:
  explicit LineReader(const std::filesystem::path& path)
      : path_(path.string()), text_(content(path)) {
    next_line();
  }

  /// Goes to the next line that has any words; false at the end of the file.
  bool next() {
    words_.clear();
    while (words_.empty() && next_line()) split();
    return !words_.empty();
  }

  const std::vector<std::string_view>& words() const { return words_; }

  /// The words behind # in this line.
  std::string_view comment() const { return comment_; }

  int number() const { return number_; }

  [[noreturn]] void fail(const std::string& what) const { fail_at(number_, what); }

  [[noreturn]] void fail_at(int number, const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", path_, number, what));
  }

  void require_columns(std::size_t low, std::size_t high, std::string_view form) const {
    if (words_.size() < low || words_.size() > high) {
      fail(fmt::format("expected `{}`, got {} columns", form, words_.size()));
    }
  }

  double real(std::size_t column) const {
    const std::string word(words_[column]);
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (end != word.c_str() + word.size() || !std::isfinite(value)) {
      fail(fmt::format("`{}` is not a finite number", shown(word)));
    }
    return value;
  }

  /// The whole number in this column, `low` … `high`; `what` names it in an error.
  std::int64_t whole(std::size_t column, std::int64_t low, std::int64_t high,
                     const char* what) const {
    const std::string_view word = words_[column];
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || value < low || value > high) {
      fail(high == kLargestId
               ? fmt::format("{} `{}`, allowed: whole number from {}", what, shown(word), low)
               : fmt::format("{} `{}`, allowed {} … {}", what, shown(word), low, high));
    }
    return value;
  }

 private:
  bool next_line() {
    if (place_ >= text_.size()) return false;
    ++number_;
    const std::size_t end = text_.find('\n', place_);
    if (end == std::string::npos) {
      fail("the last line has no end: part of the file may be missing");
    }
    line_ = std::string_view(text_).substr(place_, end - place_);
    place_ = end + 1;
    return true;
  }

  void split() {
    const std::size_t hash = line_.find('#');
    comment_ =
        trimmed(hash == std::string_view::npos ? std::string_view() : line_.substr(hash + 1));
    const std::string_view text = line_.substr(0, hash);
    std::size_t end = 0;
    for (std::size_t begin = text.find_first_not_of(kBlanks); begin != std::string_view::npos;
         begin = text.find_first_not_of(kBlanks, end)) {
      end = std::min(text.find_first_of(kBlanks, begin), text.size());
      words_.push_back(text.substr(begin, end - begin));
    }
  }

  static std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
  }

  static constexpr const char* kBlanks = " \t\r\v\f";

  std::string path_;
  std::string text_;
  std::size_t place_ = 0;  ///< of the next line
  std::string_view line_;
  std::string_view comment_;
  std::vector<std::string_view> words_;  ///< of the line
  int number_ = 0;
};

/// How an atom is written.
struct AtomStyle {
  std::string_view name;
  std::string_view form;
  std::size_t x;  ///< column
  bool charged;
};
constexpr std::array<AtomStyle, 3> kStyles{{{"molecular", "id molecule type x y z", 3, false},
                                            {"bond", "id molecule type x y z", 3, false},
                                            {"full", "id molecule type charge x y z", 4, true}}};

/// What the file says, filled in line by line.
class DataFile {
 public:
  explicit DataFile(const std::filesystem::path& path) : reader_(path) {
    while (reader_.next()) {
      if (std::isalpha(static_cast<unsigned char>(reader_.words().front().front())) != 0) {
        finish();
        begin();
      } else {
        read_line();
      }
    }
    finish();
    if (seen_.count("Atoms") == 0) reader_.fail("the file has no section Atoms");
    if (seen_.count("Bonds") == 0) reader_.fail("the file has no section Bonds");
    unwrap();
    require_distinct_atoms();
  }

  LammpsLattice lattice() && {
    PointArray points(static_cast<Eigen::Index>(atoms_.size()), 2);
    for (std::size_t k = 0; k < atoms_.size(); ++k) {
      points.row(static_cast<Eigen::Index>(k)) = atoms_[k].place.transpose();
    }
    const bool charged = std::any_of(atoms_.begin(), atoms_.end(),
                                     [](const Atom& atom) { return atom.charge != 0.0; });
    return {make_lattice(std::move(points), std::move(bonds_)), charged};
  }

 private:
  struct Atom {
    std::int64_t id;
    std::int64_t type;
    Eigen::Array2d place;
    double charge;
    int line;
  };

  void begin() {
    section_ = fmt::format("{}", fmt::join(reader_.words(), " "));
    static const std::set<std::string> known{"Masses", "Atoms", "Velocities", "Bonds"};
    if (known.count(section_) == 0) {
      reader_.fail(fmt::format(
          "section {}: what it says is not followed here, allowed: {}; take it out if the lattice "
          "is meant without",
          shown(section_), fmt::join(known, ", ")));
    }
    if (!seen_.insert(section_).second) reader_.fail(fmt::format("section {} again", section_));
    if (section_ == "Atoms") {
      if (atom_count_ < 0) reader_.fail("no line `N atoms` before the section Atoms");
      choose_style(std::string(reader_.comment()));
    }
    if (section_ == "Bonds") {
      if (bond_count_ < 0) reader_.fail("no line `N bonds` before the section Bonds");
      if (seen_.count("Atoms") == 0) {
        reader_.fail("the section Bonds comes before the section Atoms");
      }
    }
  }

  void choose_style(const std::string& hint) {
    if (hint.empty()) return;
    const auto* style = std::find_if(kStyles.begin(), kStyles.end(),
                                     [&](const AtomStyle& known) { return known.name == hint; });
    if (style == kStyles.end()) {
      reader_.fail(fmt::format("atom style {}: allowed bond, molecular and full{}", shown(hint),
                               hint == "atomic" ? "; it has no bonds" : ""));
    }
    style_ = style;
  }

  /// Where the file does not name the style, the columns tell it.
  void guess_style() {
    const std::size_t columns = reader_.words().size();
    if (columns == 5 || columns == 8) reader_.fail("atom style atomic: it has no bonds");
    style_ = columns == 7 || columns == 10 ? &kStyles.back() : &kStyles.front();
  }

  void read_line() {
    if (section_.empty()) return read_header_line();
    if (section_ == "Masses") return read_mass();
    if (section_ == "Atoms") return read_atom();
    if (section_ == "Velocities") return read_velocity();
    read_bond();
  }

  void read_header_line() {
    const auto& words = reader_.words();
    const std::string_view last = words.back();
    if (words.size() == 2 && last == "atoms") {
      atom_count_ = reader_.whole(0, 3, kMostAtoms, "number of atoms");
    } else if (words.size() == 2 && last == "bonds") {
      bond_count_ = reader_.whole(0, 2, kMostBonds, "number of bonds");
    } else if (words.size() == 2 &&
               (last == "angles" || last == "dihedrals" || last == "impropers")) {
      reader_.whole(0, 0, 0, fmt::format("number of {}", last).c_str());
    } else if (words.size() == 4 && (last == "xhi" || last == "yhi")) {
      box_(last == "xhi" ? 0 : 1) = reader_.real(1) - reader_.real(0);
    } else if (words.size() == 6 && last == "yz") {
      reader_.fail("a tilted box, allowed: a rectangular one");
    }
  }

  void read_mass() {
    reader_.require_columns(2, 2, "type mass");
    masses_[reader_.whole(0, 1, kLargestId, "atom type")] = {reader_.real(1), reader_.number()};
  }

  void read_atom() {
    if (style_ == nullptr) guess_style();
    const std::size_t x = style_->x;
    reader_.require_columns(x + 3, x + 6, style_->form);
    if (reader_.words().size() % 3 != x % 3) {
      reader_.fail(fmt::format("expected `{}`, alone or with three image flags", style_->form));
    }
    Atom atom{};
    atom.id = reader_.whole(0, 1, kLargestId, "atom");
    atom.type = reader_.whole(2, 1, kLargestId, "atom type");
    if (style_->charged) atom.charge = reader_.real(3);
    atom.place = {reader_.real(x), reader_.real(x + 1)};
    if (reader_.real(x + 2) != 0.0) {
      reader_.fail(fmt::format("z = {}, allowed 0", shown(reader_.words()[x + 2])));
    }
    atom.line = reader_.number();
    if (reader_.words().size() > x + 3) apply_image_flags(x + 3, atom);
    if (static_cast<std::int64_t>(atoms_.size()) == atom_count_) {
      reader_.fail(fmt::format("more atoms than the {} of the header", atom_count_));
    }
    atoms_.push_back(atom);
  }

  void apply_image_flags(std::size_t column, Atom& atom) {
    constexpr std::int64_t kMost = 1000000;
    for (int axis = 0; axis < 3; ++axis) {
      const std::int64_t image =
          reader_.whole(column + static_cast<std::size_t>(axis), axis < 2 ? -kMost : 0,
                        axis < 2 ? kMost : 0, "image flag");
      if (image == 0) continue;
      if (std::isnan(box_(axis))) reader_.fail("an image flag without a box");
      atom.place(axis) += static_cast<double>(image) * box_(axis);
      has_images_ = true;
    }
  }

  void read_velocity() {
    for (std::size_t k = 1; k < reader_.words().size(); ++k) {
      if (reader_.real(k) != 0.0) {
        reader_.fail("section Velocities: a lattice is at rest in itself, allowed 0");
      }
    }
  }

  void read_bond() {
    reader_.require_columns(4, 4, "id type atom atom");
    const std::int64_t id = reader_.whole(0, 1, kLargestId, "bond");
    if (!bond_ids_.insert(id).second) reader_.fail(fmt::format("bond {} again", id));
    const std::int64_t type = reader_.whole(1, 1, kLargestId, "bond type");
    if (!bonds_.empty() && type != bond_type_) {
      reader_.fail(
          fmt::format("bond type {} beside {}: all bonds follow the one law of "
                      "material.k_a and k_b",
                      type, bond_type_));
    }
    bond_type_ = type;
    const std::int32_t a = index_of(2);
    const std::int32_t b = index_of(3);
    if (a == b) {
      reader_.fail(fmt::format("atom {} is bonded to itself", shown(reader_.words()[2])));
    }
    bonds_.push_back({std::min(a, b), std::max(a, b)});
    bond_lines_.push_back(reader_.number());
  }

  std::int32_t index_of(std::size_t column) const {
    const std::int64_t id = reader_.whole(column, 1, kLargestId, "atom");
    const auto atom =
        std::lower_bound(atoms_.begin(), atoms_.end(), id,
                         [](const Atom& one, std::int64_t wanted) { return one.id < wanted; });
    if (atom == atoms_.end() || atom->id != id) {
      reader_.fail(fmt::format("atom {} is not in the section Atoms", id));
    }
    return static_cast<std::int32_t>(atom - atoms_.begin());
  }

  void finish() {
    if (section_ == "Atoms") finish_atoms();
    if (section_ == "Bonds") {
      if (static_cast<std::int64_t>(bonds_.size()) != bond_count_) {
        reader_.fail(fmt::format("{} bonds, the header says {}", bonds_.size(), bond_count_));
      }
      require_distinct_bonds();
    }
    require_equal_masses();
  }

  void finish_atoms() {
    if (static_cast<std::int64_t>(atoms_.size()) != atom_count_) {
      reader_.fail(fmt::format("{} atoms, the header says {}", atoms_.size(), atom_count_));
    }
    std::stable_sort(atoms_.begin(), atoms_.end(),
                     [](const Atom& a, const Atom& b) { return a.id < b.id; });
    const auto same = std::adjacent_find(atoms_.begin(), atoms_.end(),
                                         [](const Atom& a, const Atom& b) { return a.id == b.id; });
    if (same != atoms_.end()) {
      reader_.fail_at(std::next(same)->line, fmt::format("atom {} again", same->id));
    }
  }

  /// All points of a disk have the mass M/N.
  void require_equal_masses() const {
    if (atoms_.empty() || masses_.empty()) return;
    const auto first = masses_.find(atoms_.front().type);
    for (const Atom& atom : atoms_) {
      const auto mass = masses_.find(atom.type);
      if (mass == masses_.end()) {
        reader_.fail_at(atom.line, fmt::format("type {} has no mass", atom.type));
      }
      if (first != masses_.end() && mass->second.first != first->second.first) {
        reader_.fail_at(mass->second.second,
                        fmt::format("mass {} beside {}: all points have the same mass M/N",
                                    mass->second.first, first->second.first));
      }
    }
  }

  /// Puts each atom at the image that is nearest to those that it is bonded to. With image flags
  /// the file has said where it is.
  void unwrap() {
    if (!box_.isFinite().any()) return;
    if (!has_images_) go_along_bonds();
    for (std::size_t k = 0; k < bonds_.size(); ++k) {
      const Eigen::Array2d way = vector(bonds_[k]);
      for (int axis = 0; axis < 2; ++axis) {
        if (!is_too_long(way(axis), axis)) continue;
        reader_.fail_at(bond_lines_[k],
                        fmt::format("the bond of atoms {} and {} is longer than half of the box: "
                                    "enlarge that, if nothing is wrapped",
                                    id(bonds_[k].first), id(bonds_[k].second)));
      }
    }
  }

  /// Longer than half of the box, if there is one; what is equal to the rounding of the file is
  /// not.
  bool is_too_long(double way, int axis) const {
    constexpr double kRounding = 1e-6;
    return std::abs(way) > (0.5 + kRounding) * box_(axis);
  }

  void go_along_bonds() {
    std::vector<std::vector<std::int32_t>> neighbours(atoms_.size());
    for (const Bond& bond : bonds_) {
      neighbours[static_cast<std::size_t>(bond.first)].push_back(bond.second);
      neighbours[static_cast<std::size_t>(bond.second)].push_back(bond.first);
    }
    std::vector<bool> reached(atoms_.size(), false);
    std::vector<std::int32_t> next{0};
    reached[0] = true;
    while (!next.empty()) {
      const std::int32_t from = next.back();
      next.pop_back();
      for (const std::int32_t to : neighbours[static_cast<std::size_t>(from)]) {
        if (reached[static_cast<std::size_t>(to)]) continue;
        reached[static_cast<std::size_t>(to)] = true;
        next.push_back(to);
        Eigen::Array2d& place = atoms_[static_cast<std::size_t>(to)].place;
        for (int axis = 0; axis < 2; ++axis) {
          const double way = place(axis) - atoms_[static_cast<std::size_t>(from)].place(axis);
          if (is_too_long(way, axis)) place(axis) -= std::round(way / box_(axis)) * box_(axis);
        }
      }
    }
  }

  Eigen::Array2d vector(const Bond& bond) const {
    return atoms_[static_cast<std::size_t>(bond.second)].place -
           atoms_[static_cast<std::size_t>(bond.first)].place;
  }

  std::int64_t id(std::int32_t index) const { return atoms_[static_cast<std::size_t>(index)].id; }

  void require_distinct_atoms() const {
    const auto place = [this](std::int32_t i) {
      const Eigen::Array2d& at = atoms_[static_cast<std::size_t>(i)].place;
      return std::make_pair(at.x(), at.y());
    };
    const auto same = first_pair(
        atoms_.size(), [&](auto a, auto b) { return place(a) < place(b); },
        [&](auto a, auto b) { return place(a) == place(b); });
    if (!same) return;
    const auto line = [this](std::int32_t i) { return atoms_[static_cast<std::size_t>(i)].line; };
    reader_.fail_at(std::max(line(same->first), line(same->second)),
                    fmt::format("atoms {} and {} coincide", id(same->first), id(same->second)));
  }

  void require_distinct_bonds() const {
    const auto bond = [this](std::int32_t k) { return bonds_[static_cast<std::size_t>(k)]; };
    const auto same = first_pair(
        bonds_.size(), [&](auto a, auto b) { return bond(a) < bond(b); },
        [&](auto a, auto b) { return bond(a) == bond(b); });
    if (!same) return;
    const auto line = [this](std::int32_t k) { return bond_lines_[static_cast<std::size_t>(k)]; };
    reader_.fail_at(std::max(line(same->first), line(same->second)),
                    fmt::format("atoms {} and {} are bonded twice", id(bond(same->first).first),
                                id(bond(same->first).second)));
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

  LineReader reader_;
  std::string section_;
  std::set<std::string> seen_;  ///< sections
  std::int64_t atom_count_ = -1;
  std::int64_t bond_count_ = -1;
  /// Width and height; NaN: not given.
  Eigen::Array2d box_ = Eigen::Array2d::Constant(std::numeric_limits<double>::quiet_NaN());
  const AtomStyle* style_ = nullptr;
  bool has_images_ = false;
  std::map<std::int64_t, std::pair<double, int>> masses_;  ///< and line, by type
  std::vector<Atom> atoms_;                                ///< by id, when all are read
  std::vector<Bond> bonds_;
  std::vector<int> bond_lines_;
  std::unordered_set<std::int64_t> bond_ids_;
  std::int64_t bond_type_ = 0;
};

}  // namespace

LammpsLattice read_lammps_data(const std::filesystem::path& path) {
  DataFile file(path);
  try {
    return std::move(file).lattice();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

}  // namespace impact
