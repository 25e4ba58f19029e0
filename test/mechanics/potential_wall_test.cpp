#include "mechanics/potential_wall.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace impact {
namespace {

PointArray points_at(std::initializer_list<double> heights) {
  PointArray points = PointArray::Zero(static_cast<Eigen::Index>(heights.size()), 2);
  Eigen::Index i = 0;
  for (const double height : heights) points(i++, 1) = height;
  return points;
}

TEST(PotentialWall, PushesUpWithItsExponential) {
  PotentialWall wall(300.0, 0.25);
  const PointArray points = points_at({0.01, 0.02});
  PointArray force = PointArray::Zero(2, 2);
  wall.add_forces(points, force);
  EXPECT_DOUBLE_EQ(force(0, 1), 75.0 * std::exp(-3.0));
  EXPECT_DOUBLE_EQ(force(1, 1), 75.0 * std::exp(-6.0));
  EXPECT_TRUE((force.col(0) == 0.0).all());
  EXPECT_DOUBLE_EQ(wall.total_force().y(), force.col(1).sum());
  EXPECT_DOUBLE_EQ(wall.largest_force(), force(0, 1));
}

/// F = −dV/dy = a V, for every point.
TEST(PotentialWall, ForceIsEnergyTimesInverseRange) {
  PotentialWall wall(300.0, 0.25);
  const PointArray points = points_at({-0.01, 0.0, 0.05, 0.1});
  PointArray force = PointArray::Zero(4, 2);
  wall.add_forces(points, force);
  EXPECT_NEAR(wall.total_force().y() / (300.0 * wall.potential_energy(points)), 1.0, 1e-14);
}

/// Beyond 60/a the force is left out; what is left out is below e⁻⁶⁰ = 10⁻²⁶ of a V₀.
TEST(PotentialWall, FarPointsFeelNothing) {
  PotentialWall wall(300.0, 0.25);
  PointArray force = PointArray::Zero(1, 2);
  wall.add_forces(points_at({0.2001}), force);
  EXPECT_EQ(force(0, 1), 0.0);
  wall.add_forces(points_at({0.1999}), force);
  EXPECT_GT(force(0, 1), 0.0);
}

TEST(PotentialWall, HeightsInvertForceAndEnergy) {
  const PotentialWall wall(300.0, 0.25);
  EXPECT_NEAR(wall.force_at(wall.gap_of_force(1e-3)), 1e-3, 1e-15);

  PointArray points = points_at({0.5, 0.501, 0.8});
  const double height = wall.height_of_energy(points, 1e-10);
  points.col(1) += height - 0.5;
  EXPECT_NEAR(wall.potential_energy(points) / 1e-10, 1.0, 1e-12);
}

TEST(PotentialWall, StiffnessIsTheSlopeOfTheForce) {
  const PotentialWall wall(300.0, 0.25);
  constexpr double kStep = 1e-7;
  const double slope = (wall.force_at(0.03 - kStep) - wall.force_at(0.03 + kStep)) / (2 * kStep);
  // Truncation of the central difference: (a step)²/6 = 1.5·10⁻¹⁰.
  EXPECT_NEAR(wall.stiffness(wall.force_at(0.03)) / slope, 1.0, 1e-8);
}

}  // namespace
}  // namespace impact
