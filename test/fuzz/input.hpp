#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "lattice/input_error.hpp"

namespace impact {

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Runs the body; an InputError must be one line that is not endless.
template <class Body>
void must_be_one_line(const Body& body) {
  constexpr std::size_t kLongest = 2000;
  try {
    body();
  } catch (const InputError& error) {
    const std::string line = error.what();
    if (line.empty() || line.size() > kLongest || line.find('\n') != std::string::npos) {
      std::abort();
    }
  }
}

}  // namespace impact
