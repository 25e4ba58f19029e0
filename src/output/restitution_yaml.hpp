#pragma once

#include <string>

#include "measure/impact_answer.hpp"
#include "scene/parameter_table.hpp"

namespace impact {

/// Adds what an impact did to a result, to the last bit; `suffix` follows the name of each number.
/// `slides`: whether those are wanted that say something only of a disk which slides along the
/// wall.
template <class Numbers>
void add_impact(const Numbers& numbers, const std::string& suffix, bool slides,
                YAML::Node& result) {
  for (const auto& [key, member] : impact_numbers<Numbers>()) {
    if (is_of_sliding(key) && !slides) continue;
    result[key + suffix] = exact(numbers.*member);
  }
}

/// A list of flags, on one line.
template <class Flags>
YAML::Node flag_list(const Flags& flags) {
  YAML::Node list(YAML::NodeType::Sequence);
  list.SetStyle(YAML::EmitterStyle::Flow);
  for (const auto& flag : flags) list.push_back(flag);
  return list;
}

}  // namespace impact
