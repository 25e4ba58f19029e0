#include "mechanics/first_order_form.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test_lattices.hpp"

namespace impact {
namespace {

TEST(FirstOrderForm, GivesBackTheStateItTook) {
  const PointArray points = triangle().points;
  const FirstOrderForm form(3);
  Eigen::VectorXd y(form.size());
  form.pack({0.0, 0, points, 2.0 * points}, y.data());
  State state;
  form.unpack(y.data(), state);
  EXPECT_TRUE((state.position == points).all());
  EXPECT_TRUE((state.velocity == 2.0 * points).all());
  EXPECT_EQ(form.losses(y.data()).dissipated, 0.0);
  EXPECT_EQ(form.losses(y.data()).absorbed, 0.0);
}

TEST(FirstOrderForm, RateIsVelocityAccelerationAndPower) {
  ForceField field{BondForces(triangle(), {1.0, 0.0, 0.3}), 1.0 / 3.0};
  field.viscous_boundary.emplace(std::vector<ViscousBoundary::Dashpot>{{2, {1.0, 2.0}}});
  const PointArray position = 1.1 * triangle().points;
  const PointArray velocity = PointArray::Random(3, 2);
  FirstOrderForm form(3);
  Eigen::VectorXd y(form.size());
  form.pack({0.0, 0, position, velocity}, y.data());
  Eigen::VectorXd rate(form.size());
  EXPECT_TRUE(form.evaluate(field, y.data(), rate.data()));

  PointArray force(3, 2);
  const Losses power = field.evaluate(position, velocity, force);
  State found;
  form.unpack(rate.data(), found);
  EXPECT_TRUE((found.position == velocity).all());
  EXPECT_TRUE((found.velocity == force / field.point_mass).all());
  EXPECT_EQ(form.losses(rate.data()).dissipated, power.dissipated);
  EXPECT_EQ(form.losses(rate.data()).absorbed, power.absorbed);
}

TEST(FirstOrderForm, SaysWhenTheRateIsNotFinite) {
  ForceField field{BondForces(triangle(), {1.0, 0.0, 0.0}), 1.0 / 3.0};
  FirstOrderForm form(3);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(form.size());
  y(1) = std::nan("");
  Eigen::VectorXd rate(form.size());
  EXPECT_FALSE(form.evaluate(field, y.data(), rate.data()));
}

TEST(FirstOrderForm, TolerancesAreInTheScalesGiven) {
  const ForceField field{BondForces(triangle(), {1.0, 0.0, 0.0}), 0.5};
  const FirstOrderForm form(3);
  Eigen::VectorXd tolerances(form.size());
  form.scale(field, 0.1, {2.0, 3.0}, tolerances.data());
  EXPECT_TRUE((tolerances.head(6).array() == 0.1 * 2.0).all());
  EXPECT_TRUE((tolerances.segment(6, 6).array() == 0.1 * 3.0).all());
  EXPECT_TRUE((tolerances.tail(2).array() == 0.1 * 1.5 * 3.0 * 3.0).all());
}

}  // namespace
}  // namespace impact
