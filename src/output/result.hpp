#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "scene/parameter_table.hpp"

namespace impact {

/// What came out of a run, by the keys under which programs give it, in their order.
struct Result {
  /// A number, a truth, a word, or a list of words.
  using Value = std::variant<double, bool, std::string, std::vector<std::string>>;

  std::vector<std::pair<std::string, Value>> entries;

  /// nullptr: it has none of that key.
  const Value* find(const std::string& key) const;
  bool has(const std::string& key) const { return find(key) != nullptr; }
  /// NaN: it has no number of that key.
  double number(const std::string& key) const;
  /// The list under `flags`; empty where there is none.
  std::vector<std::string> flags() const;
};

/// Numbers to the last bit, lists on one line.
YAML::Node to_yaml(const Result& result);

/// @param map such YAML, also of somebody else: what is neither a scalar nor a list is left out
Result read_result(const YAML::Node& map);

}  // namespace impact
