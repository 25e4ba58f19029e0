#include "output/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/tokenizer.hpp>
#include <cmath>

namespace impact {

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\\\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter == '\n' ? "\\n" : std::string(1, letter);
  }
  return quoted + "\"";
}

std::string csv_number(double value) {
  return std::isnan(value) ? "nan" : fmt::format("{}", value);
}

std::string csv_line(const std::vector<std::string>& texts) {
  std::vector<std::string> quoted(texts.size());
  std::transform(texts.begin(), texts.end(), quoted.begin(), csv_cell);
  return fmt::format("{}", fmt::join(quoted, ","));
}

std::vector<std::string> cells_of(const std::string& line) {
  const boost::tokenizer<boost::escaped_list_separator<char>> tokens(line);
  return {tokens.begin(), tokens.end()};
}

}  // namespace impact
