#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/parameter_table.hpp"
#include "scene/scene.hpp"

namespace impact {

/// Every key of a scene file: unit, range, meaning, in which kind of scene it exists.
const std::vector<Parameter<Scene>>& scene_parameters();

/// Whether the scene can have the method `reduced`: the impact of an undamped disk, which does not
/// spin, on the potential wall without gravity.
bool can_be_reduced(const Scene& scene);

/// Whether the scene can have the method `modal`: the impact of a disk, damped or not, which
/// neither spins nor slides, on the potential wall without gravity.
bool can_be_modal(const Scene& scene);

/// The words for the integrators in scenes, messages and results.
const std::vector<std::pair<std::string, IntegratorKind>>& integrator_names();
std::string name_of(IntegratorKind kind);

/// The scene that these keys describe; keys that are absent keep their defaults, `scene` itself
/// must be there.
/// @throw InputError as read_parameters(), and for values that do not go together.
Scene parse_scene(const FlatTree& keys, const std::vector<std::string>& other_names = {});

/// The same of keys that hold one value each.
/// @throw InputError as parse_scene(), and for a list of values, which is a series.
Scene parse_single_scene(const FlatTree& keys);

/// The most scenes that a series has.
constexpr std::size_t kMostScenes = 100'000;

/// A key and a YAML list of the values that it takes in turn.
using KeyValues = std::pair<std::string, YAML::Node>;

/// The scenes of all combinations of the values, the last key changing fastest; the other keys are
/// those of `keys`.
/// @throw InputError as parse_scene(), for an empty list or one that has a value twice, and for
/// more than kMostScenes combinations; every scene is checked before any is returned.
std::vector<Scene> parse_combinations(FlatTree keys, const std::vector<KeyValues>& lists,
                                      const std::vector<std::string>& other_names = {});

/// The keys of the tree that have a list, in alphabetical order.
std::vector<KeyValues> lists_of(const FlatTree& keys);

/// A series: a key of the tree may hold a list of values, which then are taken in turn; with
/// several lists, all combinations, the last key in alphabetical order changing fastest.
/// @throw InputError as parse_combinations().
std::vector<Scene> parse_series(const FlatTree& keys,
                                const std::vector<std::string>& other_names = {});

/// The scene as YAML; parse_scene() of it gives the same bits.
std::string to_yaml(const Scene& scene);

}  // namespace impact
