#include "scene/scene_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "lattice/input_error.hpp"
#include "scene/suggestion.hpp"

namespace impact {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".yaml";

std::vector<std::string> scenes_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() == kExtension) names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

fs::path scene_folder() {
  const fs::path programs = fs::read_symlink("/proc/self/exe").parent_path();
  return programs.parent_path().parent_path() / "share" / programs.filename() / "launch" / "scenes";
}

fs::path scene_path(const std::string& scene, const fs::path& folder) {
  fs::path path = scene;
  std::error_code none;
  if (path.has_parent_path() || path.has_extension() || fs::exists(path, none)) return path;
  fs::path named = folder / (scene + kExtension);
  if (fs::exists(named, none)) return named;
  const std::vector<std::string> names = scenes_in(folder);
  throw InputError(fmt::format("{}: no such scene{}, allowed: a scene file{}{}", shown(scene),
                               suggestion(scene, names), names.empty() ? "" : ", ",
                               fmt::join(names, ", ")));
}

}  // namespace impact
