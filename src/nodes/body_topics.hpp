#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "mechanics/body.hpp"

namespace impact {

/// What the topics of the body of this number begin with, below the simulation's namespace: nothing
/// for the disk, then wall/, wall2/, wall3/.
inline std::string topics_of_body(std::size_t number) {
  return number == 0 ? "" : name_of_body(number) + "/";
}

/// The bodies of a run with topics of their own, of which a status says that they are so many.
inline std::size_t bodies_said(std::uint32_t bodies) {
  return std::clamp<std::size_t>(bodies, 1, kMostBodies);
}

}  // namespace impact
