#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/parameter_table.hpp"

namespace impact {

/// `key=value`, taken apart.
using Assignment = std::pair<std::string, std::string>;

/// @throw InputError when the text is not of the form; `form` is what it says is allowed.
Assignment parse_assignment(const std::string& text, const std::string& form = "key=value");

/// The assignments with their keys in full: `velocity` is `impact.velocity` where no other key of
/// such a scene ends so; `k_a`, `k_b` and `eta` are the material's. The scene is that of `keys`, in
/// which assignments may change `scene` and `wall.type`, on which its keys depend; a value may be a
/// list `v1,v2,…`. A key that the scene does not have stays as it is.
/// @throw InputError for a short key that more than one key ends in.
std::vector<Assignment> with_full_keys(FlatTree keys, std::vector<Assignment> assignments);

/// Replaces or adds the keys of the assignments (`impact.velocity=0.02`, `velocity=0.02`).
/// @throw InputError when one is not of the form key=value, and as with_full_keys().
void override_keys(FlatTree& keys, const std::vector<std::string>& assignments);

/// The keys of a scene file, or of a scene by its name, with these assignments.
/// @throw InputError as scene_path(), load_keys() and override_keys().
FlatTree keys_of_scene(const std::string& scene, const std::vector<std::string>& assignments);

}  // namespace impact
