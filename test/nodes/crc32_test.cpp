#include "nodes/crc32.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>
#include <vector>

namespace impact {
namespace {

TEST(Crc32, HasTheCheckValueOfTheStandard) {
  const char* const digits = "123456789";
  std::vector<std::uint8_t> bytes(std::strlen(digits));
  std::memcpy(bytes.data(), digits, bytes.size());
  EXPECT_EQ(crc32_of(bytes.data(), bytes.size()), 0xCBF43926U);
}

TEST(Crc32, IsThatOfZlibAtEveryLengthAndPlace) {
  std::vector<std::uint8_t> bytes(3000);
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    bytes[k] = static_cast<std::uint8_t>((k * 2654435761U) >> 13U);
  }
  for (std::size_t size = 0; size + 64 < bytes.size(); size += 1 + size / 7) {
    const std::uint8_t* const start = bytes.data() + size % 64;
    EXPECT_EQ(crc32_of(start, size), crc32_z(0, start, size)) << size;
  }
}

}  // namespace
}  // namespace impact
