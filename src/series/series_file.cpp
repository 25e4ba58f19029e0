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
#include "scene/version.hpp"
#include "series/convergence_study.hpp"

namespace impact {
namespace {

constexpr const char* kFailed = "failed: ";
const std::vector<std::string> kKeysOfPart{"version", "run"};

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

std::vector<std::string> keys_of_scenes(const std::vector<Scene>& scenes) {
  std::vector<std::string> keys;
  for (const Parameter<Scene>& parameter : scene_parameters()) {
    if (std::any_of(scenes.begin(), scenes.end(), parameter.applies)) keys.push_back(parameter.key);
  }
  return keys;
}

/// The keys that any result has. One that is missing so far goes behind the one that it follows.
std::vector<std::string> keys_of_results(const std::vector<Scene>& scenes) {
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

/// The line behind its first cells, which are not quoted.
std::string without_cells(const std::string& line, std::size_t count) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < count; ++i) begin = line.find(',', begin) + 1;
  return line.substr(begin);
}

}  // namespace

bool has_failed(const Row& row) { return begins_with(row.flags, kFailed); }

Result failure(const std::string& reason) {
  return {{{"flags", std::vector<std::string>{kFailed + reason}}}};
}

SeriesColumns::SeriesColumns(const std::vector<Scene>& series)
    : scene_keys(keys_of_scenes(series)), result_keys(keys_of_results(series)) {}

SeriesFile::SeriesFile(const std::filesystem::path& path, const std::vector<Scene>& scenes)
    : SeriesFile(path, OutputLock::of_file(path), SeriesColumns(scenes), {scenes, {}}) {}

SeriesFile::SeriesFile(const std::filesystem::path& path, const SeriesColumns& columns,
                       SeriesPart part)
    : SeriesFile(path, OutputLock::of_file(path), columns, std::move(part)) {}

SeriesFile SeriesFile::so_far(const std::filesystem::path& path, const SeriesColumns& columns,
                              SeriesPart part) {
  return {path, std::nullopt, columns, std::move(part)};
}

SeriesFile::SeriesFile(std::filesystem::path path, std::optional<OutputLock> lock,
                       SeriesColumns columns, SeriesPart part)
    : path_(std::move(path)),
      lock_(std::move(lock)),
      columns_(std::move(columns)),
      part_(std::move(part)) {
  if (lock_ || std::filesystem::exists(path_)) read(read_file(path_));
}

std::vector<std::string> SeriesFile::names() const {
  std::vector<std::string> all = is_part() ? kKeysOfPart : std::vector<std::string>();
  all.insert(all.end(), columns_.scene_keys.begin(), columns_.scene_keys.end());
  all.insert(all.end(), columns_.result_keys.begin(), columns_.result_keys.end());
  return all;
}

/// Those before its results. Line 0 is the header.
std::vector<std::string> SeriesFile::expected_cells(std::size_t line) const {
  if (line > scenes().size()) {
    throw misfit(line, fmt::format("this series has {} runs only", scenes().size()));
  }
  if (line == 0) return names();
  std::vector<std::string> cells = scene_texts(scenes()[line - 1], columns_.scene_keys);
  if (is_part()) cells.insert(cells.begin(), {version(), fmt::to_string(part_.numbers[line - 1])});
  return cells;
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
  const std::vector<std::string> columns = names();
  const std::vector<std::string> expected = expected_cells(line);
  std::vector<std::string> cells;
  try {
    cells = cells_of(text);
  } catch (const boost::escaped_list_error& error) {
    throw misfit(line, error.what());
  }
  if (cells.size() != columns.size()) {
    throw misfit(line,
                 fmt::format("got {} columns, this series has {}", cells.size(), columns.size()));
  }
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (cells[i] == expected[i]) continue;
    throw misfit(line, fmt::format("{}: got {}, this series has {}", columns[i], csv_cell(cells[i]),
                                   csv_cell(expected[i])));
  }
  if (line == 0) return;
  add_row(cells);
  if (is_part()) lines_.push_back(without_cells(text, kKeysOfPart.size()));
}

void SeriesFile::add_row(const std::vector<std::string>& cells) {
  Row row{scenes()[rows_.size()], {}, cells.back()};
  const std::size_t first = cells.size() - columns_.result_keys.size();
  for (std::size_t i = 0; i < columns_.result_keys.size(); ++i) {
    const std::string& cell = cells[first + i];
    row.results[columns_.result_keys[i]] = number(cell);
    if (columns_.result_keys[i] == "integrator") row.integrator = cell;
  }
  rows_.push_back(std::move(row));
}

void SeriesFile::open() {
  std::error_code error;
  std::filesystem::resize_file(path_, complete_bytes_, error);
  file_.open(path_, std::ios::binary | std::ios::app);
  if (error || !file_) throw InputError(fmt::format("{}: cannot be written", path_.string()));
  if (complete_bytes_ == 0) write(csv_line(names()));
}

void SeriesFile::append(const Result& result) {
  std::vector<std::string> cells = expected_cells(rows_.size() + 1);
  Row row{scenes()[rows_.size()],
          {},
          value_text(result.find("flags")),
          value_text(result.find("integrator"))};
  for (const std::string& key : columns_.result_keys) {
    cells.push_back(value_text(result.find(key)));
    row.results[key] = result.number(key);
  }
  write(csv_line(cells));
  rows_.push_back(std::move(row));
}

void SeriesFile::append_line(const std::string& line) {
  read_line(rows_.size() + 1, line);
  write(line);
}

void SeriesFile::write(const std::string& line) {
  file_ << line << '\n' << std::flush;
  if (!file_) throw std::runtime_error(fmt::format("{} cannot be written", path_.string()));
}

}  // namespace impact
