#include "scene/short_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "scene/keys.hpp"
#include "scene/scene_files.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

/// The keys on which it depends which others a scene has.
constexpr std::array<const char*, 2> kDecisive{"scene", "wall.type"};

bool ends_in(const std::string& key, const std::string& name) {
  const std::size_t dot = key.rfind('.');
  return dot != std::string::npos && key.compare(dot + 1, std::string::npos, name) == 0;
}

/// The values of a list, in YAML or as `v1,v2,…`, or the only one.
std::vector<YAML::Node> values_of(const YAML::Node& node) {
  if (node.IsSequence()) return {node.begin(), node.end()};
  std::vector<YAML::Node> values;
  if (!node.IsScalar()) return values;
  std::istringstream text(node.Scalar());
  for (std::string value; std::getline(text, value, ',');) values.emplace_back(value);
  return values;
}

const Parameter<Scene>& parameter_of(const std::string& key) {
  const auto& table = scene_parameters();
  return *std::find_if(table.begin(), table.end(),
                       [&](const Parameter<Scene>& parameter) { return parameter.key == key; });
}

/// A scene for each set of keys that a scene may have.
std::vector<Scene> possible_scenes(const FlatTree& keys) {
  std::vector<Scene> scenes{Scene{}};
  for (const char* const key : kDecisive) {
    const auto found = keys.find(key);
    if (found == keys.end()) continue;
    std::vector<Scene> changed;
    for (const YAML::Node& value : values_of(found->second)) {
      for (Scene scene : scenes) {
        if (parameter_of(key).read(scene, value)) changed.push_back(scene);
      }
    }
    if (!changed.empty()) scenes = std::move(changed);
  }
  return scenes;
}

std::string full_key(const std::vector<Scene>& scenes, const std::string& name) {
  std::vector<std::string> meant;
  for (const Parameter<Scene>& parameter : scene_parameters()) {
    if (parameter.key == name) return name;
    if (ends_in(parameter.key, name) &&
        std::any_of(scenes.begin(), scenes.end(), parameter.applies)) {
      meant.push_back(parameter.key);
    }
  }
  const auto of_material = std::find_if(meant.begin(), meant.end(), [](const std::string& key) {
    return key.rfind("material.", 0) == 0;
  });
  if (of_material != meant.end()) return *of_material;
  if (meant.size() > 1) {
    throw InputError(
        fmt::format("{}: ambiguous, allowed: {}", shown(name), fmt::join(meant, " or ")));
  }
  return meant.empty() ? name : meant.front();
}

}  // namespace

Assignment parse_assignment(const std::string& text, const std::string& form) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) {
    throw InputError(fmt::format("{}: allowed: {}", shown(text), form));
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

std::vector<Assignment> with_full_keys(FlatTree keys, std::vector<Assignment> assignments) {
  for (const char* const decisive : kDecisive) {
    for (const auto& [key, value] : assignments) {
      if (key == decisive || ends_in(decisive, key)) {
        keys[decisive].reset(parse_value(key, value));
      }
    }
  }
  const std::vector<Scene> scenes = possible_scenes(keys);
  for (Assignment& assignment : assignments) assignment.first = full_key(scenes, assignment.first);
  return assignments;
}

void override_keys(FlatTree& keys, const std::vector<std::string>& assignments) {
  std::vector<Assignment> parsed;
  parsed.reserve(assignments.size());
  for (const std::string& text : assignments) parsed.push_back(parse_assignment(text));
  for (const auto& [key, value] : with_full_keys(keys, std::move(parsed))) {
    keys[key].reset(parse_value(key, value));
  }
}

FlatTree keys_of_scene(const std::string& scene, const std::vector<std::string>& assignments) {
  FlatTree keys = load_keys(scene_path(scene));
  override_keys(keys, assignments);
  return keys;
}

}  // namespace impact
