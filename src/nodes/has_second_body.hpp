#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "mechanics/contact_names.hpp"

namespace impact {

/// What the topics of a second body begin with, below the simulation's namespace.
inline const std::string kOfSecondBody = "wall/";

/// Whether a run with these terms has a second body, with topics of its own.
inline bool has_second_body(const std::vector<std::string>& terms) {
  return std::any_of(terms.begin(), terms.end(), [](const std::string& term) {
    return term == kElasticWallName || term == kDiskContactName;
  });
}

}  // namespace impact
