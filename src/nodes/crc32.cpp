#include "nodes/crc32.hpp"

#include <isa-l/crc.h>

namespace impact {

std::uint32_t crc32_of(const std::uint8_t* bytes, std::size_t size) {
  return crc32_gzip_refl(0, bytes, size);
}

}  // namespace impact
