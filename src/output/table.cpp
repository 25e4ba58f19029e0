#include "output/table.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

#include "output/csv.hpp"

namespace impact {

Table::Table(const std::vector<std::string>& columns)
    : columns_(columns.size()), text_(csv_line(columns) + "\n") {}

Table& Table::operator<<(double value) { return *this << csv_number(value); }

Table& Table::operator<<(const std::string& text) {
  ++cells_;
  text_ += csv_cell(text);
  text_ += cells_ % columns_ == 0 ? '\n' : ',';
  return *this;
}

void Table::write(const std::filesystem::path& path) const {
  const std::filesystem::path unfinished = path.string() + ".part";
  std::ofstream file(unfinished, std::ios::binary);
  file << text_;
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(unfinished, path, error);
  if (!file || error) {
    std::filesystem::remove(unfinished, error);
    throw std::runtime_error(fmt::format("{} cannot be written", path.string()));
  }
}

}  // namespace impact
