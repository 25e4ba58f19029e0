#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lattice/input_error.hpp"
#include "output/output_lock.hpp"
#include "output/result.hpp"
#include "scene/scene.hpp"

namespace impact {

/// A scene and what came out of it.
struct Row {
  Scene scene;
  std::map<std::string, double> results;  ///< by result key; NaN for what is no number
  std::string flags;                      ///< separated by ';'
  std::string integrator{};
};

/// True for a run that could not go on.
bool has_failed(const Row& row);

/// The result of a run that could not go on.
Result failure(const std::string& reason);

/// The keys that are the columns of a series' file: every scene key that one of the scenes has,
/// then every result key.
struct SeriesColumns {
  explicit SeriesColumns(const std::vector<Scene>& series);

  std::vector<std::string> scene_keys;
  std::vector<std::string> result_keys;
};

/// Some rows of a series that have a file of their own.
struct SeriesPart {
  std::vector<Scene> scenes;
  std::vector<std::size_t> numbers;  ///< of these scenes in the series, rising, counted from 1
};

/// A CSV file with a row for each scene of a series, in their order. What a scene does not have is
/// left empty. A text with a comma, quote, backslash or line break is quoted, with backslashes as
/// in C. The file of a part has two columns before those of the series: the `version` of the
/// program that made the row, and its number as a `run` of the series.
class SeriesFile {
 public:
  /// Takes in the rows that the file already has; a half-written last line does not count. The file
  /// stays as it is; nobody else writes to it meanwhile.
  /// @throw InputError as OutputLock::of_file(), and when the file does not begin as this series
  /// does.
  SeriesFile(const std::filesystem::path& path, const std::vector<Scene>& scenes);
  /// @param columns of the series.
  /// @throw InputError as the other constructor, and for a row of another version.
  SeriesFile(const std::filesystem::path& path, const SeriesColumns& columns, SeriesPart part);
  /// What a part's file has at present, which may be none; others may write to it, append() and
  /// open() may not.
  /// @throw InputError when the file does not begin as this part does.
  static SeriesFile so_far(const std::filesystem::path& path, const SeriesColumns& columns,
                           SeriesPart part);

  const std::vector<Scene>& scenes() const { return part_.scenes; }
  const std::vector<Row>& rows() const { return rows_; }
  /// The rows of a part as a file of the series has them.
  const std::vector<std::string>& lines() const { return lines_; }

  /// Makes the file ready for the next row: cuts off a half-written line.
  /// @throw InputError when it cannot be written.
  void open();

  /// Writes the row of the next scene into the open file.
  /// @param result by the keys of quantities(); keys may be absent
  /// @throw std::runtime_error when it cannot be written.
  void append(const Result& result);
  /// Writes the row of the next scene, one of the lines() of a part, into the open file.
  /// @throw as append(), and InputError when it is not the row of that scene.
  void append_line(const std::string& line);

 private:
  SeriesFile(std::filesystem::path path, std::optional<OutputLock> lock, SeriesColumns columns,
             SeriesPart part);

  bool is_part() const { return !part_.numbers.empty(); }
  std::vector<std::string> names() const;
  std::vector<std::string> expected_cells(std::size_t line) const;
  void read(const std::string& content);
  void read_line(std::size_t line, const std::string& text);
  void check_half_line(std::size_t line, const std::string& text) const;
  InputError misfit(std::size_t line, const std::string& reason) const;
  void add_row(const std::vector<std::string>& cells);
  void write(const std::string& line);

  std::filesystem::path path_;
  std::optional<OutputLock> lock_;  ///< none: only to be read
  SeriesColumns columns_;
  SeriesPart part_;  ///< without numbers: the series
  std::vector<Row> rows_;
  std::vector<std::string> lines_;
  std::uintmax_t complete_bytes_ = 0;  ///< of the file, up to its last line break
  std::ofstream file_;
};

}  // namespace impact
