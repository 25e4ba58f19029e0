#pragma once

#include <lattice_impact/ContactForces.h>
#include <lattice_impact/ParticleStates.h>
#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <cstring>

namespace impact {

/// A message of this type as it goes over the wire, to be handed on unread, or serialised once for
/// all who get it. The type must begin with `header` and `run`. Copies share the bytes, and a
/// publisher writes its count of messages into them, header.seq.
template <class Message>
struct RawMessage {
  RawMessage() = default;
  /// Of a message, or of what is serialised to the same bytes.
  template <class Source>
  explicit RawMessage(const Source& source)
      : run(source.run), wire(ros::serialization::serializeMessage(source)) {}

  /// Without the length that goes before it.
  std::uint32_t size() const {
    return static_cast<std::uint32_t>(wire.num_bytes - sizeof(std::uint32_t));
  }

  std::uint32_t run = 0;
  ros::SerializedMessage wire;
};

}  // namespace impact

/// roscpp and rosbag take it for the message itself.
namespace ros::message_traits {

template <class Message>
struct MD5Sum<impact::RawMessage<Message>> {
  static const char* value() { return MD5Sum<Message>::value(); }
  static const char* value(const impact::RawMessage<Message>& /*message*/) { return value(); }
};

template <class Message>
struct DataType<impact::RawMessage<Message>> {
  static const char* value() { return DataType<Message>::value(); }
  static const char* value(const impact::RawMessage<Message>& /*message*/) { return value(); }
};

template <class Message>
struct Definition<impact::RawMessage<Message>> {
  static const char* value() { return Definition<Message>::value(); }
  static const char* value(const impact::RawMessage<Message>& /*message*/) { return value(); }
};

}  // namespace ros::message_traits

namespace ros::serialization {

template <class Message>
struct Serializer<impact::RawMessage<Message>> {
  /// @throw ros::serialization::StreamOverrunException where not even the run is there.
  template <class Stream>
  static void read(Stream& stream, impact::RawMessage<Message>& message) {
    const std::uint32_t size = stream.getLength();
    const std::size_t all = sizeof size + size;
    message.wire =
        ros::SerializedMessage(boost::shared_array<std::uint8_t>(new std::uint8_t[all]), all);
    OStream start(message.wire.buf.get(), static_cast<std::uint32_t>(all));
    start.next(size);
    message.wire.message_start = start.getData();
    std::memcpy(message.wire.message_start, stream.getData(), size);
    std_msgs::Header header;
    stream.next(header);
    stream.next(message.run);
    stream.advance(stream.getLength());
  }

  template <class Stream>
  static void write(Stream& stream, const impact::RawMessage<Message>& message) {
    const std::uint32_t size = message.size();
    std::memcpy(stream.advance(size), message.wire.message_start, size);
  }

  // NOLINTNEXTLINE(readability-identifier-naming): roscpp calls it
  static std::uint32_t serializedLength(const impact::RawMessage<Message>& message) {
    return message.size();
  }
};

/// What the simulation publishes without a copy.
template <>
inline SerializedMessage serializeMessage(
    const impact::RawMessage<lattice_impact::ParticleStates>& message) {
  return message.wire;
}
template <>
inline SerializedMessage serializeMessage(
    const impact::RawMessage<lattice_impact::ContactForces>& message) {
  return message.wire;
}

}  // namespace ros::serialization
