#pragma once

#include <string>
#include <vector>

namespace impact {

/// The text as a cell of a CSV file: in quotes where it has a comma, a quote, a backslash or a line
/// break, those behind a backslash and a line break as \\n.
std::string csv_cell(const std::string& text);

/// A number as a cell, with all its digits.
std::string csv_number(double value);

/// The cells in a line, without its end.
std::string csv_line(const std::vector<std::string>& texts);

/// The texts of the cells of such a line.
/// @throw boost::escaped_list_error when it is not one.
std::vector<std::string> cells_of(const std::string& line);

}  // namespace impact
