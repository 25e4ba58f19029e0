#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
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

/// A CSV file with a row for each scene of a series, in their order: every scene key that one of
/// the scenes has, then every result key. What a scene does not have is left empty. A text with a
/// comma, quote, backslash or line break is quoted, with backslashes as in C.
class SeriesFile {
 public:
  /// Takes in the rows that the file already has; a half-written last line does not count. The file
  /// stays as it is; nobody else writes to it meanwhile.
  /// @throw InputError as OutputLock::of_file(), and when the file does not begin as this series
  /// does.
  SeriesFile(std::filesystem::path path, std::vector<Scene> scenes);

  const std::vector<Scene>& scenes() const { return scenes_; }
  const std::vector<Row>& rows() const { return rows_; }

  /// Makes the file ready for the next row: cuts off a half-written line.
  /// @throw InputError when it cannot be written.
  void open();

  /// Writes the row of the next scene into the open file.
  /// @param result by the keys of quantities(); keys may be absent
  /// @throw std::runtime_error when it cannot be written.
  void append(const Result& result);

 private:
  std::vector<std::string> columns() const;
  std::vector<std::string> expected_cells(std::size_t line) const;
  void read(const std::string& content);
  void read_line(std::size_t line, const std::string& text);
  void check_half_line(std::size_t line, const std::string& text) const;
  InputError misfit(std::size_t line, const std::string& reason) const;
  void add_row(const std::vector<std::string>& cells);
  void write(const std::string& line);

  std::filesystem::path path_;
  OutputLock lock_;
  std::vector<Scene> scenes_;
  std::vector<std::string> scene_keys_;
  std::vector<std::string> result_keys_;
  std::vector<Row> rows_;
  std::uintmax_t complete_bytes_ = 0;  ///< of the file, up to its last line break
  std::ofstream file_;
};

}  // namespace impact
