#pragma once

#include <lattice_impact/RunStatus.h>
#include <ros/serialization.h>

#include <cstdint>
#include <cstring>

#include "nodes/crc32.hpp"
#include "nodes/raw_message.hpp"

namespace impact {

/// CRC-32 of a message as it goes over the wire, but for header.seq, which every publisher counts
/// for itself.
template <class Message>
std::uint64_t checksum_of(const Message& message) {
  const ros::SerializedMessage bytes = ros::serialization::serializeMessage(message);
  std::memset(bytes.message_start, 0, sizeof message.header.seq);  // it comes first
  return crc32_of(bytes.buf.get(), bytes.num_bytes);
}

/// The same of one that was not yet published.
template <class Message>
std::uint64_t checksum_of(const RawMessage<Message>& message) {
  return crc32_of(message.wire.buf.get(), message.wire.num_bytes);
}

/// RunStatus::checksum after messages with this sum, and this one.
inline std::uint64_t checksum_with(std::uint64_t sum, lattice_impact::RunStatus status) {
  status.checksum = 0;
  return sum + checksum_of(status);
}

}  // namespace impact
