#pragma once

#include <filesystem>
#include <string>

#include "scene/parameter_table.hpp"

/// Scene files and `key=value` as trees of keys, before anything is known of their meaning.
namespace impact {

/// The tree of a YAML text; `name` is what errors call it.
/// @throw InputError when it is not one YAML document.
FlatTree parse_keys(const std::string& yaml, const std::string& name);

/// The tree of a YAML file.
/// @throw InputError when it cannot be read, and as parse_keys().
FlatTree load_keys(const std::filesystem::path& path);

/// The value of `key` as YAML.
/// @throw InputError when it is not one YAML document.
YAML::Node parse_value(const std::string& key, const std::string& text);

}  // namespace impact
