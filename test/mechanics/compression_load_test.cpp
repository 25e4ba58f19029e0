#include "mechanics/compression_load.hpp"

#include <gtest/gtest.h>

namespace impact {
namespace {

TEST(CompressionLoad, SpreadsEvenly) {
  const CompressionLoad load(0.4);
  PointArray force = PointArray::Zero(8, 2);
  load.add_forces(PointArray::Zero(8, 2), force);
  EXPECT_TRUE((force.col(0) == 0.0).all());
  EXPECT_TRUE((force.col(1) == -0.05).all());
}

TEST(CompressionLoad, EnergyIsLoadTimesHeightOfTheCentre) {
  PointArray position(2, 2);
  position << 5, 1, 7, 2;
  EXPECT_DOUBLE_EQ(CompressionLoad(0.4).potential_energy(position), 0.4 * 1.5);
}

}  // namespace
}  // namespace impact
