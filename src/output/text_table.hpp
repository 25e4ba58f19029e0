#pragma once

#include <string>
#include <vector>

namespace impact {

/// Lines of cells; all as long as the first.
using TextTable = std::vector<std::vector<std::string>>;

/// Columns that a terminal takes for a text in UTF-8 without wide characters.
std::size_t display_width(const std::string& text);

/// As lines of right-aligned columns.
std::string aligned(const TextTable& table);

}  // namespace impact
