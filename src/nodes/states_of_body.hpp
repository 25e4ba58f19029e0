#pragma once

#include <ros/serialization.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <cstring>

#include "mechanics/body.hpp"
#include "mechanics/state.hpp"

namespace impact {

/// What ParticleStates says of a body, to be written to the wire from where the state lies, without
/// a message between.
struct StatesOfBody {
  std_msgs::Header header;
  std::uint32_t run = 0;
  std::uint32_t sequence = 0;
  const State& state;  ///< of all bodies
  const Body& body;
};

}  // namespace impact

namespace ros::serialization {

/// In the order of ParticleStates.msg.
template <>
struct Serializer<impact::StatesOfBody> {
  template <class Stream>
  static void write(Stream& stream, const impact::StatesOfBody& states) {
    stream.next(states.header);
    stream.next(states.run);
    stream.next(states.sequence);
    stream.next(states.state.step);
    stream.next(states.state.time);
    for (const impact::PointArray* points : {&states.state.position, &states.state.velocity}) {
      for (const Eigen::Index column : {0, 1}) {
        write_array(stream, points->data() + column * points->rows() + states.body.first,
                    static_cast<std::uint32_t>(states.body.points));
      }
    }
  }

  // NOLINTNEXTLINE(readability-identifier-naming): roscpp calls it
  static std::uint32_t serializedLength(const impact::StatesOfBody& states) {
    const auto points = static_cast<std::size_t>(states.body.points);
    const std::size_t array = sizeof(std::uint32_t) + points * sizeof(double);
    const std::size_t numbers = 2 * sizeof(std::uint32_t) + sizeof(std::uint64_t) + sizeof(double);
    return serializationLength(states.header) + static_cast<std::uint32_t>(numbers + 4 * array);
  }

 private:
  template <class Stream>
  static void write_array(Stream& stream, const double* values, std::uint32_t size) {
    const auto bytes = static_cast<std::uint32_t>(size * sizeof(double));
    stream.next(size);
    std::memcpy(stream.advance(bytes), values, bytes);
  }
};

}  // namespace ros::serialization
