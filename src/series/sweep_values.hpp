#pragma once

#include <string>
#include <vector>

#include "scene/parameter_table.hpp"
#include "scene/scene.hpp"

namespace impact {

/// The values that a text stands for: `v`, `v1,v2,…`, `lo:hi:n` (n values at equal distances, both
/// ends included) or `lo:hi:n:log` (at equal ratios). What lies between the ends is rounded to 12
/// digits, or to a whole number for a key of whole numbers. A key that takes a text has no ranges.
/// @throw InputError for any other text with a colon or brackets.
std::vector<std::string> sweep_values(const std::string& key, const std::string& text);

/// The scenes of all combinations of the values in the assignments (`key=values`), the last key
/// changing fastest. A list within `keys` is taken as in parse_series(), and changes faster still.
/// @throw InputError as sweep_values() and parse_series(), for a key given twice, and for more
/// than 100,000 combinations.
std::vector<Scene> parse_sweep(const FlatTree& keys, const std::vector<std::string>& assignments);

}  // namespace impact
