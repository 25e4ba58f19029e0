#pragma once

#include <array>
#include <utility>

#include "scene/parameter_table.hpp"

namespace impact {

/// The names in results of what an impact did. `Numbers` is impact::Restitution or the message of
/// that name.
template <class Numbers>
constexpr auto restitution_keys() {
  using Key = std::pair<const char*, double Numbers::*>;
  return std::array<Key, 8>{{{"restitution", &Numbers::restitution},
                             {"tangential_velocity_after", &Numbers::tangential_velocity_after},
                             {"spin_after", &Numbers::spin_after},
                             {"contact_begin", &Numbers::contact_begin},
                             {"contact_end", &Numbers::contact_end},
                             {"contact_duration", &Numbers::contact_duration},
                             {"peak_force", &Numbers::peak_force},
                             {"impulse", &Numbers::impulse}}};
}

/// Adds what an impact did to a result, to the last bit.
template <class Numbers>
void add_restitution(const Numbers& numbers, YAML::Node& result) {
  for (const auto& [key, member] : restitution_keys<Numbers>()) {
    result[key] = exact(numbers.*member);
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
