#pragma once

#include "scene/parameter_table.hpp"

namespace impact {

/// Adds what an impact did to a result, to the last bit. `Numbers` is impact::Restitution or the
/// message of that name.
template <class Numbers>
void add_restitution(const Numbers& numbers, YAML::Node& result) {
  result["restitution"] = exact(numbers.restitution);
  result["tangential_velocity_after"] = exact(numbers.tangential_velocity_after);
  result["spin_after"] = exact(numbers.spin_after);
  result["contact_begin"] = exact(numbers.contact_begin);
  result["contact_end"] = exact(numbers.contact_end);
  result["contact_duration"] = exact(numbers.contact_duration);
  result["peak_force"] = exact(numbers.peak_force);
  result["impulse"] = exact(numbers.impulse);
}

/// Adds a list of flags, on one line.
template <class Flags>
void add_flags(const Flags& flags, YAML::Node& result) {
  YAML::Node list(YAML::NodeType::Sequence);
  list.SetStyle(YAML::EmitterStyle::Flow);
  for (const auto& flag : flags) list.push_back(flag);
  result["flags"] = list;
}

}  // namespace impact
