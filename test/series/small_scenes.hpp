#pragma once

#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "scene/scene_parameters.hpp"

namespace impact {

inline std::vector<Scene> scenes(const std::string& yaml) {
  return parse_series(flatten(YAML::Load(yaml)));
}

/// Runs of unequal length, the longest first, so that threads finish out of order.
inline std::vector<Scene> small_scenes() {
  return scenes(
      "{scene: collision, disk: {points: 40}, numerics: {step: [0.001, 0.05]}, seed: [1, 2, 3]}");
}

inline std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The only number that may differ between two runs, and stands before the flags.
inline std::string without_wall_time(const std::string& csv) {
  return std::regex_replace(csv, std::regex(",[^,\n]*,([^,\n]*)\n"), ",$1\n");
}

}  // namespace impact
