#pragma once

#include <lattice_impact/ContactForces.h>
#include <lattice_impact/Lattice.h>
#include <lattice_impact/LawFit.h>
#include <lattice_impact/ParticleStates.h>
#include <lattice_impact/Restitution.h>
#include <lattice_impact/RunStatus.h>
#include <lattice_impact/Scalars.h>
#include <lattice_impact/Strain.h>
#include <ros/serialization.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "nodes/checksum.hpp"
#include "scene/keys.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {

/// A message of a bag as bytes, whether or not they are still a message.
struct Record {
  std::string topic;
  ros::Time time;
  std::string type;
  std::string md5sum;
  std::vector<std::uint8_t> bytes;
};

/// Refuses lengths of arrays that no message here has; roscpp would ask for the memory first.
class LimitedStream : public ros::serialization::IStream {
 public:
  explicit LimitedStream(std::vector<std::uint8_t>& bytes)
      : IStream(bytes.data(), static_cast<std::uint32_t>(bytes.size())) {}

  template <class T>
  void next(T& value) {
    ros::serialization::deserialize(*this, value);
  }
  template <class T, class Allocator>
  void next(std::vector<T, Allocator>& values) {
    constexpr std::uint32_t kMost = 1U << 20U;
    std::uint32_t size = 0;
    if (getLength() >= sizeof size) std::memcpy(&size, getData(), sizeof size);
    if (size > kMost) throw std::length_error("an array");
    ros::serialization::deserialize(*this, values);
  }
};

template <class Message>
bool is_a(const Record& record) {
  return record.type == ros::message_traits::DataType<Message>::value() &&
         record.md5sum == ros::message_traits::MD5Sum<Message>::value();
}

/// @throw std::length_error, ros::serialization::StreamOverrunException
template <class Message>
Message message_of(Record record) {
  LimitedStream stream(record.bytes);
  Message message;
  ros::serialization::deserialize(stream, message);
  return message;
}

template <class Message>
void put(const Message& message, Record& record) {
  const ros::SerializedMessage bytes = ros::serialization::serializeMessage(message);
  record.bytes.assign(bytes.message_start, bytes.buf.get() + bytes.num_bytes);
}

/// The same scene in as few words as will do, so that most of the time is not that of YAML.
inline std::string in_short(const std::string& scene) {
  const Scene full = parse_scene(parse_keys(scene, "scene"));
  const std::string keys =
      full.kind == SceneKind::kContact
          ? fmt::format("material: {{eta: {}}}, load: {{P: {}}}", full.material.eta, full.load.p)
          : fmt::format("impact: {{velocity: {}}}", full.impact.velocity);
  const std::string text = fmt::format(
      "{{scene: {}, disk: {{points: 3}}, {}, output: {{period: {}}}}}",
      full.kind == SceneKind::kContact ? "contact" : "collision", keys, full.output.period);
  if (to_yaml(parse_scene(parse_keys(text, "scene"))) != to_yaml(full)) std::abort();
  return text;
}

inline void shorten_scene(Record& record) {
  auto status = message_of<lattice_impact::RunStatus>(record);
  status.checksum -= checksum_with(0, status);
  status.scene = in_short(status.scene);
  status.checksum = checksum_with(status.checksum, status);
  put(status, record);
}

/// What record.py has recorded.
inline std::vector<Record> recording() {
  rosbag::Bag bag(SOURCE_DIR "/test/fuzz/recorded.bag");
  rosbag::View view(bag);
  std::vector<Record> records;
  for (const rosbag::MessageInstance& message : view) {
    Record record{message.getTopic(), message.getTime(), message.getDataType(), message.getMD5Sum(),
                  std::vector<std::uint8_t>(message.size())};
    ros::serialization::OStream stream(record.bytes.data(), message.size());
    message.write(stream);
    if (is_a<lattice_impact::RunStatus>(record)) shorten_scene(record);
    records.push_back(record);
  }
  return records;
}

}  // namespace impact
