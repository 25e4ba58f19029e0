#pragma once

#include <cstddef>
#include <cstdint>

namespace impact {

/// CRC-32 of ISO 3309, that of gzip: by ISA-L where the build found it, otherwise by zlib.
std::uint32_t crc32_of(const std::uint8_t* bytes, std::size_t size);

}  // namespace impact
