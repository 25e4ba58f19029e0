#pragma once

#include <filesystem>
#include <string>

namespace impact {

/// Becomes plot_figures, which lies beside this program, to draw these figures of the CSV files of
/// a folder.
/// @throw std::runtime_error when it cannot be started.
[[noreturn]] void plot(const std::filesystem::path& folder, const std::string& figure);

}  // namespace impact
