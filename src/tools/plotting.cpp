#include "tools/plotting.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "lattice/input_error.hpp"

namespace impact {

void make_output_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(fmt::format("--output: {}: {}", folder.string(), error.message()));
}

void plot(const std::filesystem::path& folder, const std::string& figure) {
  const std::string program =
      std::filesystem::read_symlink("/proc/self/exe").replace_filename("plot_figures").string();
  execl(program.c_str(), program.c_str(), figure.c_str(), folder.c_str(), nullptr);
  throw std::runtime_error(
      fmt::format("{}: {}; the CSV files are complete", program, std::strerror(errno)));
}

}  // namespace impact
