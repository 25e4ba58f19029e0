#pragma once

#include <filesystem>
#include <string>

namespace impact {

/// Creates the folder for results.
/// @throw InputError when it cannot be.
void make_output_folder(const std::filesystem::path& folder);

/// Becomes plot_figures, which lies beside this program, to draw these figures of the CSV files of
/// a folder.
/// @throw std::runtime_error when it cannot be started.
[[noreturn]] void plot(const std::filesystem::path& folder, const std::string& figure);

}  // namespace impact
