#include "output/output_folder.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <utility>

#include "lattice/input_error.hpp"

namespace impact {
namespace {

bool exists_or_is_made(const std::filesystem::path& folder) {
  std::error_code error;
  if (std::filesystem::exists(folder, error)) return true;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(fmt::format("{}: {}", folder.string(), error.message()));
  return false;
}

}  // namespace

OutputFolder::OutputFolder(const std::filesystem::path& path)
    : path_(path), was_there_(exists_or_is_made(path)), lock_(OutputLock::of_folder(path)) {}

OutputFolder::~OutputFolder() {
  std::error_code not_empty;
  if (!was_there_) std::filesystem::remove(path_, not_empty);
}

ResultFiles::ResultFiles(std::filesystem::path folder, std::vector<std::string> names)
    : folder_(std::move(folder)), names_(std::move(names)) {}

ResultFiles::~ResultFiles() {
  std::error_code ignored;
  for (const std::string& name : names_) std::filesystem::remove(beside(name), ignored);
}

std::filesystem::path ResultFiles::beside(const std::string& name) const {
  return folder_ / (name + ".part");
}

void ResultFiles::write(const std::string& name, const std::string& text) const {
  std::ofstream file(beside(name), std::ios::binary);
  file << text;
  if (!file.flush()) {
    throw std::runtime_error(fmt::format("{} cannot be written", beside(name).string()));
  }
}

void ResultFiles::take_their_places() {
  std::error_code error;
  for (const std::string& name : names_) {
    if (!error) std::filesystem::remove(folder_ / name, error);
  }
  for (auto name = names_.rbegin(); name != names_.rend() && !error; ++name) {
    if (!std::filesystem::exists(beside(*name))) continue;
    std::filesystem::rename(beside(*name), folder_ / *name, error);
  }
  if (error) {
    throw std::runtime_error(fmt::format("{}: the result could not be put there: {}",
                                         folder_.string(), error.message()));
  }
}

}  // namespace impact
