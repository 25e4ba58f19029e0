#include <zlib.h>

#include "nodes/crc32.hpp"

namespace impact {

std::uint32_t crc32_of(const std::uint8_t* bytes, std::size_t size) {
  return static_cast<std::uint32_t>(crc32_z(0, bytes, size));
}

}  // namespace impact
