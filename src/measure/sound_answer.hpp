#pragma once

#include <algorithm>
#include <array>
#include <string>

namespace impact {

/// Whether the answer of a run with these flags belongs into a mean or a fit: the model's own
/// answer, be the lattice folded or the contact hopping from bond to bond, and not one of too
/// coarse a step, a start inside the wall's reach, a wall cut off, or a run given up.
template <class Flags>
bool is_sound(const Flags& flags) {
  const std::array<std::string, 3> harmless{"step_reduced", "folded", "hops"};
  return std::all_of(flags.begin(), flags.end(), [&harmless](const std::string& flag) {
    return std::find(harmless.begin(), harmless.end(), flag) != harmless.end();
  });
}

}  // namespace impact
