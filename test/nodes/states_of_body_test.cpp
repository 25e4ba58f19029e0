#include "nodes/states_of_body.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "lattice/placement.hpp"
#include "nodes/conversions.hpp"

namespace impact {
namespace {

TEST(StatesOfBody, AreTheBytesOfTheMessage) {
  const State all{0.5, 17, place_in_disk({50}, 1), place_in_disk({50}, 2)};
  Body body;
  body.first = 20;
  body.points = 10;
  lattice_impact::ParticleStates message =
      to_message(State{all.time, all.step, body.rows_of(all.position), body.rows_of(all.velocity)});
  message.header.stamp = ros::Time(3, 4);
  message.header.frame_id = "somewhere";
  message.run = 5;
  message.sequence = 6;
  const ros::SerializedMessage expected = ros::serialization::serializeMessage(message);
  const ros::SerializedMessage found = ros::serialization::serializeMessage(
      StatesOfBody{message.header, message.run, message.sequence, all, body});
  ASSERT_EQ(found.num_bytes, expected.num_bytes);
  EXPECT_EQ(std::memcmp(found.buf.get(), expected.buf.get(), found.num_bytes), 0);
}

}  // namespace
}  // namespace impact
