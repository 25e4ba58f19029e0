#pragma once

#include <algorithm>
#include <array>
#include <string>

namespace impact {

/// Whether the answer of a run with these flags belongs into a mean or a fit: the model's own
/// answer, be the lattice folded, the contact hopping from bond to bond or the place of rest one of
/// several, and not one of too coarse a step, a start inside the wall's reach, a wall cut off or
/// too narrow, or a run given up.
template <class Flags>
bool is_sound(const Flags& flags) {
  const std::array<std::string, 6> harmless{"step_reduced",  "folded",         "hops",
                                            "several_rests", "charge_ignored", "floppy"};
  return std::all_of(flags.begin(), flags.end(), [&harmless](const std::string& flag) {
    return std::find(harmless.begin(), harmless.end(), flag) != harmless.end();
  });
}

}  // namespace impact
