#include "mechanics/compression_load.hpp"

#include <gtest/gtest.h>

namespace impact {
namespace {

TEST(CompressionLoad, SpreadsEvenly) {
  const CompressionLoad load(0.4, 8);
  PointArray force = PointArray::Zero(8, 2);
  load.add_forces(PointArray::Zero(8, 2), force);
  EXPECT_TRUE((force.col(0) == 0.0).all());
  EXPECT_TRUE((force.col(1) == -0.05).all());
}

TEST(CompressionLoad, EnergyIsLoadTimesHeightOfTheCentre) {
  PointArray position(2, 2);
  position << 5, 1, 7, 2;
  EXPECT_DOUBLE_EQ(CompressionLoad(0.4, 2).potential_energy(position), 0.4 * 1.5);
}

/// What lies below, an elastic wall, carries none of it.
TEST(CompressionLoad, ActsOnTheFirstBodyAlone) {
  PointArray position(3, 2);
  position << 5, 1, 7, 2, 0, -9;
  const CompressionLoad load(0.4, 2);
  PointArray force = PointArray::Zero(3, 2);
  load.add_forces(position, force);
  EXPECT_EQ(force(0, 1), -0.2);
  EXPECT_EQ(force(1, 1), -0.2);
  EXPECT_EQ(force(2, 1), 0.0);
  EXPECT_DOUBLE_EQ(load.potential_energy(position), 0.4 * 1.5);
}

}  // namespace
}  // namespace impact
