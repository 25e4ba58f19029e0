#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "scene/parameter_table.hpp"
#include "scene/scene.hpp"

namespace impact {

/// Every key of a scene file: unit, range, meaning, in which kind of scene it exists.
const std::vector<Parameter<Scene>>& scene_parameters();

/// The words for the integrators in scenes, messages and results.
const std::vector<std::pair<std::string, IntegratorKind>>& integrator_names();
std::string name_of(IntegratorKind kind);

/// The scene that these keys describe; keys that are absent keep their defaults, `scene` itself
/// must be there.
/// @throw InputError as read_parameters(), and for values that do not go together.
Scene parse_scene(const FlatTree& keys, const std::string& other_names = {});

/// A series: a key of the tree may hold a list of values, which then are taken in turn; with
/// several lists, all combinations, the last key in alphabetical order changing fastest.
/// @throw InputError as parse_scene(); every run is checked before any is returned.
std::vector<Scene> parse_series(const FlatTree& keys, const std::string& other_names = {});

/// The scene as YAML; parse_scene() of it gives the same bits.
std::string to_yaml(const Scene& scene);

/// The tree of a YAML file.
/// @throw InputError when it cannot be read or is not YAML.
FlatTree load_keys(const std::filesystem::path& path);

/// Replaces or adds the key of `assignment` (`impact.velocity=0.02`).
/// @throw InputError when it is not of the form key=value.
void override_key(FlatTree& keys, const std::string& assignment);

}  // namespace impact
