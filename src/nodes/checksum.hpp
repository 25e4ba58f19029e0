#pragma once

#include <lattice_impact/RunStatus.h>
#include <ros/serialization.h>
#include <zlib.h>

#include <cstdint>

namespace impact {

/// CRC-32 of a message as it goes over the wire, but for header.seq, which every publisher counts
/// for itself.
template <class Message>
std::uint64_t checksum_of(Message message) {
  message.header.seq = 0;
  const ros::SerializedMessage bytes = ros::serialization::serializeMessage(message);
  return crc32(crc32(0, nullptr, 0), bytes.buf.get(), static_cast<uInt>(bytes.num_bytes));
}

/// RunStatus::checksum after messages with this sum, and this one.
inline std::uint64_t checksum_with(std::uint64_t sum, lattice_impact::RunStatus status) {
  status.checksum = 0;
  return sum + checksum_of(status);
}

}  // namespace impact
