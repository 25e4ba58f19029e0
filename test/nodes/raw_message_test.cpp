#include "nodes/raw_message.hpp"

#include <gtest/gtest.h>
#include <lattice_impact/ContactForces.h>
#include <lattice_impact/Lattice.h>
#include <lattice_impact/LawFit.h>
#include <lattice_impact/ParticleStates.h>
#include <lattice_impact/Restitution.h>
#include <lattice_impact/Scalars.h>
#include <lattice_impact/Strain.h>

#include <cstring>
#include <vector>

#include "nodes/checksum.hpp"

namespace impact {
namespace {

using Bytes = std::vector<std::uint8_t>;

template <class Message>
Bytes bytes_of_message(const Message& message) {
  Bytes bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

template <class Message>
RawMessage<Message> read_raw(Bytes bytes) {
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  RawMessage<Message> raw;
  ros::serialization::deserialize(stream, raw);
  EXPECT_EQ(stream.getLength(), 0U);
  return raw;
}

template <class Message>
class RawMessages : public testing::Test {};
using Recorded =
    testing::Types<lattice_impact::Lattice, lattice_impact::ParticleStates,
                   lattice_impact::ContactForces, lattice_impact::Scalars, lattice_impact::Strain,
                   lattice_impact::Restitution, lattice_impact::LawFit>;
TYPED_TEST_SUITE(RawMessages, Recorded);

TYPED_TEST(RawMessages, AreHandedOnAsTheyCameAndTellTheirRun) {
  TypeParam message;
  message.header.seq = 3;
  message.header.stamp = ros::Time(4, 5);
  message.header.frame_id = "somewhere";
  message.run = 0x01020304;
  const Bytes bytes = bytes_of_message(message);
  const auto raw = read_raw<TypeParam>(bytes);
  EXPECT_EQ(raw.run, message.run);
  EXPECT_EQ(bytes_of_message(raw), bytes);
}

TYPED_TEST(RawMessages, HaveTheBytesAndTheChecksumOfTheMessage) {
  TypeParam message;
  message.header.stamp = ros::Time(4, 5);
  message.run = 7;
  const RawMessage<TypeParam> raw(message);
  EXPECT_EQ(raw.run, 7U);
  EXPECT_EQ(bytes_of_message(raw), bytes_of_message(message));
  EXPECT_EQ(checksum_of(raw), checksum_of(message));
}

TEST(RawMessage, IsPublishedWithoutACopyAndAsTheMessageIs) {
  lattice_impact::ParticleStates message;
  message.x = {1.0, 2.0};
  const RawMessage<lattice_impact::ParticleStates> raw(message);
  const ros::SerializedMessage sent = ros::serialization::serializeMessage(raw);
  const ros::SerializedMessage expected = ros::serialization::serializeMessage(message);
  EXPECT_EQ(sent.buf, raw.wire.buf);
  ASSERT_EQ(sent.num_bytes, expected.num_bytes);
  EXPECT_EQ(std::memcmp(sent.buf.get(), expected.buf.get(), sent.num_bytes), 0);
  EXPECT_EQ(sent.message_start - sent.buf.get(), expected.message_start - expected.buf.get());
}

TYPED_TEST(RawMessages, PassForTheMessageItself) {
  using namespace ros::message_traits;
  const RawMessage<TypeParam> raw;
  const TypeParam message;
  EXPECT_STREQ(md5sum(raw), md5sum(message));
  EXPECT_STREQ(datatype(raw), datatype(message));
  EXPECT_STREQ(definition(raw), definition(message));
}

TYPED_TEST(RawMessages, WithoutARunAreRefused) {
  Bytes bytes = bytes_of_message(TypeParam());
  bytes.resize(bytes_of_message(std_msgs::Header()).size() + 3);
  EXPECT_THROW(read_raw<TypeParam>(bytes), ros::serialization::StreamOverrunException);
}

}  // namespace
}  // namespace impact
