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

/// The most scenes that a series has.
constexpr std::size_t kMostScenes = 100'000;

/// The error for the key whose values make a series longer than that.
InputError too_many_scenes(const std::string& key);

/// @throw InputError when a list of values for this key has one twice: one run would count as two.
void refuse_repetitions(const std::string& key, const YAML::Node& list);

/// A series: a key of the tree may hold a list of values, which then are taken in turn; with
/// several lists, all combinations, the last key in alphabetical order changing fastest.
/// @throw InputError as parse_scene(), for a value that a list has twice and for more than
/// kMostScenes runs; every run is checked before any is returned.
std::vector<Scene> parse_series(const FlatTree& keys, const std::string& other_names = {});

/// The scene as YAML; parse_scene() of it gives the same bits.
std::string to_yaml(const Scene& scene);

/// The tree of a YAML text; `name` is what errors call it.
/// @throw InputError when it is not one YAML document.
FlatTree parse_keys(const std::string& yaml, const std::string& name);

/// The tree of a YAML file.
/// @throw InputError when it cannot be read, and as parse_keys().
FlatTree load_keys(const std::filesystem::path& path);

/// Replaces or adds the key of `assignment` (`impact.velocity=0.02`).
/// @throw InputError when it is not of the form key=value.
void override_key(FlatTree& keys, const std::string& assignment);

}  // namespace impact
