#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <std_msgs/Header.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace impact {

/// A message of this type as it goes over the wire, to be handed on unread. The type must begin
/// with `header` and `run`.
template <class Message>
struct RawMessage {
  std::uint32_t run = 0;
  std::vector<std::uint8_t> bytes;
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
    const std::uint8_t* const bytes = stream.getData();
    message.bytes.assign(bytes, bytes + size);
    std_msgs::Header header;
    stream.next(header);
    stream.next(message.run);
    stream.advance(stream.getLength());
  }

  template <class Stream>
  static void write(Stream& stream, const impact::RawMessage<Message>& message) {
    const auto size = static_cast<std::uint32_t>(message.bytes.size());
    std::copy(message.bytes.begin(), message.bytes.end(), stream.advance(size));
  }

  static std::uint32_t serializedLength(const impact::RawMessage<Message>& message) {
    return static_cast<std::uint32_t>(message.bytes.size());
  }
};

}  // namespace ros::serialization
