#include "series/series_file.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <boost/tokenizer.hpp>
#include <charconv>
#include <limits>
#include <stdexcept>
#include <utility>

#include "output/csv.hpp"
#include "scene/scene_parameters.hpp"
#include "series/convergence_study.hpp"

namespace impact {
namespace {

constexpr const char* kFailed = "failed: ";

double number(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole_text = error == std::errc() && end == text.data() + text.size();
  return whole_text ? value : std::numeric_limits<double>::quiet_NaN();
}

struct CellText {
  std::string operator()(double number) const { return csv_number(number); }
  std::string operator()(bool truth) const { return fmt::format("{}", truth); }
  std::string operator()(const std::string& word) const { return word; }
  std::string operator()(const std::vector<std::string>& words) const {
    return fmt::format("{}", fmt::join(words, ";"));
  }
};

std::string value_text(const Result::Value* value) {
  return value == nullptr ? "" : std::visit(CellText{}, *value);
}

std::vector<std::string> scene_keys(const std::vector<Scene>& scenes) {
  std::vector<std::string> keys;
  for (const Parameter<Scene>& parameter : scene_parameters()) {
    if (std::any_of(scenes.begin(), scenes.end(), parameter.applies)) keys.push_back(parameter.key);
  }
  return keys;
}

/// The keys that any result has. One that is missing so far goes behind the one that it follows.
std::vector<std::string> result_keys(const std::vector<Scene>& scenes) {
  std::vector<std::string> keys;
  for (const Scene& scene : scenes) {
    auto place = keys.begin();
    for (const Quantity& quantity : quantities(scene)) {
      const auto found = std::find(keys.begin(), keys.end(), quantity.key);
      place = 1 + (found == keys.end() ? keys.insert(place, quantity.key) : found);
    }
  }
  return keys;
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path) || !file) {
    throw InputError(fmt::format("{}: cannot be read", path.string()));
  }
  return {std::istreambuf_iterator<char>(file), {}};
}

bool begins_with(const std::string& text, const std::string& beginning) {
  return text.compare(0, beginning.size(), beginning) == 0;
}

/// The cells of the keys that this scene has; the others are empty.
std::vector<std::string> scene_texts(const Scene& scene, const std::vector<std::string>& keys) {
  std::vector<std::string> texts;
  for (const Parameter<Scene>& parameter : scene_parameters()) {
    if (std::find(keys.begin(), keys.end(), parameter.key) == keys.end()) continue;
    texts.push_back(parameter.applies(scene) ? cell_text(parameter.write(scene)) : "");
  }
  return texts;
}

}  // namespace

bool has_failed(const Row& row) { return begins_with(row.flags, kFailed); }

Result failure(const std::string& reason) {
  return {{{"flags", std::vector<std::string>{kFailed + reason}}}};
}

SeriesFile::SeriesFile(std::filesystem::path path, std::vector<Scene> scenes)
    : path_(std::move(path)),
      lock_(OutputLock::of_file(path_)),
      scenes_(std::move(scenes)),
      scene_keys_(scene_keys(scenes_)),
      result_keys_(result_keys(scenes_)) {
  read(read_file(path_));
}

std::vector<std::string> SeriesFile::columns() const {
  std::vector<std::string> names = scene_keys_;
  names.insert(names.end(), result_keys_.begin(), result_keys_.end());
  return names;
}

/// What the line must begin with; line 0 is the header.
std::vector<std::string> SeriesFile::expected_cells(std::size_t line) const {
  if (line > scenes_.size()) {
    throw misfit(line, fmt::format("this series has {} runs only", scenes_.size()));
  }
  return line == 0 ? columns() : scene_texts(scenes_[line - 1], scene_keys_);
}

InputError SeriesFile::misfit(std::size_t line, const std::string& reason) const {
  return InputError(fmt::format("{}:{}: {}", path_.string(), line + 1, reason));
}

void SeriesFile::read(const std::string& content) {
  std::size_t begin = 0;
  for (std::size_t line = 0; begin < content.size(); ++line) {
    const std::size_t end = content.find('\n', begin);
    if (end == std::string::npos) return check_half_line(line, content.substr(begin));
    read_line(line, content.substr(begin, end - begin));
    begin = end + 1;
    complete_bytes_ = begin;
  }
}

void SeriesFile::check_half_line(std::size_t line, const std::string& text) const {
  const std::string expected = csv_line(expected_cells(line));
  const std::size_t length = std::min(text.size(), expected.size());
  if (text.compare(0, length, expected, 0, length) != 0) {
    throw misfit(line, "is not a line of this series");
  }
}

void SeriesFile::read_line(std::size_t line, const std::string& text) {
  const std::vector<std::string> names = columns();
  const std::vector<std::string> expected = expected_cells(line);
  std::vector<std::string> cells;
  try {
    cells = cells_of(text);
  } catch (const boost::escaped_list_error& error) {
    throw misfit(line, error.what());
  }
  if (cells.size() != names.size()) {
    throw misfit(line,
                 fmt::format("got {} columns, this series has {}", cells.size(), names.size()));
  }
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (cells[i] == expected[i]) continue;
    throw misfit(line, fmt::format("{}: got {}, this series has {}", names[i], csv_cell(cells[i]),
                                   csv_cell(expected[i])));
  }
  if (line > 0) add_row(cells);
}

void SeriesFile::add_row(const std::vector<std::string>& cells) {
  Row row{scenes_[rows_.size()], {}, cells.back()};
  for (std::size_t i = 0; i < result_keys_.size(); ++i) {
    const std::string& cell = cells[scene_keys_.size() + i];
    row.results[result_keys_[i]] = number(cell);
    if (result_keys_[i] == "integrator") row.integrator = cell;
  }
  rows_.push_back(std::move(row));
}

void SeriesFile::open() {
  std::error_code error;
  std::filesystem::resize_file(path_, complete_bytes_, error);
  file_.open(path_, std::ios::binary | std::ios::app);
  if (error || !file_) throw InputError(fmt::format("{}: cannot be written", path_.string()));
  if (complete_bytes_ == 0) write(csv_line(columns()));
}

void SeriesFile::append(const Result& result) {
  const Scene& scene = scenes_[rows_.size()];
  std::vector<std::string> cells = scene_texts(scene, scene_keys_);
  Row row{scene, {}, value_text(result.find("flags")), value_text(result.find("integrator"))};
  for (const std::string& key : result_keys_) {
    cells.push_back(value_text(result.find(key)));
    row.results[key] = result.number(key);
  }
  write(csv_line(cells));
  rows_.push_back(std::move(row));
}

void SeriesFile::write(const std::string& line) {
  file_ << line << '\n' << std::flush;
  if (!file_) throw std::runtime_error(fmt::format("{} cannot be written", path_.string()));
}

}  // namespace impact
