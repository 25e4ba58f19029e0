#pragma once

#include "scene/parameter_table.hpp"

namespace impact {

/// This node's private parameters on the parameter server, as the tree that a scene file gives.
/// @throw InputError for a value of a type that YAML does not have.
FlatTree private_parameters();

/// Moves the keys that `table` knows from `keys` into a new tree.
template <class T>
FlatTree take_keys(FlatTree& keys, const std::vector<Parameter<T>>& table) {
  FlatTree taken;
  for (const Parameter<T>& parameter : table) {
    const auto found = keys.find(parameter.key);
    if (found == keys.end()) continue;
    taken.insert(*found);
    keys.erase(found);
  }
  return taken;
}

/// Only to see whether they can be read.
/// @throw InputError as read_parameters().
template <class T>
void check_parameters(const std::vector<Parameter<T>>& table, const FlatTree& keys) {
  T parameters;
  read_parameters(table, keys, parameters);
}

}  // namespace impact
