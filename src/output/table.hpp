#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace impact {

/// A table of results, to be written as CSV.
class Table {
 public:
  explicit Table(const std::vector<std::string>& columns);

  /// Adds a cell to the last line; a full line is followed by a new one. Numbers keep all digits.
  Table& operator<<(double value);
  Table& operator<<(const std::string& text);

  /// @throw std::runtime_error when it cannot be written. Nothing half-written stays behind.
  void write(const std::filesystem::path& path) const;

 private:
  std::size_t columns_;
  std::size_t cells_ = 0;
  std::string text_;
};

}  // namespace impact
