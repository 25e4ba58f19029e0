#include "reduced/quasi_static_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "small_disk.hpp"

namespace impact {
namespace {

constexpr double kNegligible = 1e-12;  // M c²/R

QuasiStaticContact contact_of(const SmallDisk& disk, double k_a = 1.0,
                              double negligible = kNegligible) {
  return {disk.arm, disk.compliance, k_a, *disk.field.wall, negligible};
}

/// Some 2 % of R nearer to the wall than where a single point would feel it little.
Pose pressed(const SmallDisk& disk, double angle = 0.0) {
  const Eigen::ArrayXd height =
      std::sin(angle) * disk.arm.col(0) + std::cos(angle) * disk.arm.col(1);
  return {0.015 - height.minCoeff(), angle};
}

TEST(QuasiStaticContact, ForceAndTorqueAreSlopesOfTheEnergy) {
  const SmallDisk disk;
  QuasiStaticContact contact = contact_of(disk);
  constexpr double kWay = 1e-6;
  for (const double angle : {0.0, 0.3, 2.0, -1.5}) {
    const Pose pose = pressed(disk, angle);
    contact.take(pose);
    const auto energy_at = [&](double up, double turn) {
      QuasiStaticContact other = contact;
      other.take({pose.height + up, pose.angle + turn});
      return other.energy();
    };
    const double force = (energy_at(-kWay, 0.0) - energy_at(kWay, 0.0)) / (2.0 * kWay);
    const double torque = (energy_at(0.0, -kWay) - energy_at(0.0, kWay)) / (2.0 * kWay);
    EXPECT_GT(contact.force(), 1e-3);
    EXPECT_NEAR(contact.force(), force, 1e-6 * force);
    EXPECT_NEAR(contact.torque(), torque, 1e-6 * force);
  }
}

/// Then the wall's force is that on the reference lattice.
TEST(QuasiStaticContact, OfAStiffBodyIsThatOfARigidOne) {
  SmallDisk disk;
  QuasiStaticContact contact = contact_of(disk, 1e12, 1e-30);
  const Pose pose = pressed(disk);
  contact.take(pose);
  PointArray position = disk.arm;
  position.col(1) += pose.height;
  PointArray force = PointArray::Zero(position.rows(), 2);
  disk.field.wall->add_forces(position, force);
  const double torque = (disk.arm.col(0) * force.col(1)).sum();
  EXPECT_NEAR(contact.force(), force.col(1).sum(), 1e-6 * contact.force());
  EXPECT_NEAR(contact.torque(), torque, 1e-6 * contact.force());
}

PointArray pushed(const SmallDisk& disk, const Pose& pose, const Eigen::ArrayXd& u) {
  const Eigen::Index n = disk.arm.rows();
  const Eigen::ArrayXd x = disk.arm.col(0) + u.head(n);
  const Eigen::ArrayXd y = disk.arm.col(1) + u.tail(n);
  PointArray position(n, 2);
  position.col(0) = std::cos(pose.angle) * x - std::sin(pose.angle) * y;
  position.col(1) = std::sin(pose.angle) * x + std::cos(pose.angle) * y + pose.height;
  return position;
}

/// What bonds and wall do to a point at rest is its share of what moves the whole, to the second
/// order of the strain: at a third of the force a ninth is left.
TEST(QuasiStaticContact, BalancesBondsAndWall) {
  const SmallDisk disk(60, 2.0);
  struct Unbalanced {
    double force;
    double part;
  };
  const auto unbalanced = [&](double lift) -> Unbalanced {
    QuasiStaticContact contact = contact_of(disk, 2.0, 1e-30);
    Pose pose = pressed(disk, 0.4);
    pose.height += lift;
    contact.take(pose);
    PointArray force(disk.arm.rows(), 2);
    ForceField field = disk.field;
    field.evaluate_undamped(pushed(disk, pose, contact.displacements({}).col(0)), force);
    PointArray stacked = PointArray::Zero(2 * force.rows(), 2);
    stacked.col(0) << std::cos(pose.angle) * force.col(0) + std::sin(pose.angle) * force.col(1),
        std::cos(pose.angle) * force.col(1) - std::sin(pose.angle) * force.col(0);
    disk.compliance->balance(stacked);
    return {contact.force(), stacked.abs().maxCoeff() / contact.force()};
  };
  const Unbalanced near = unbalanced(0.04);
  const Unbalanced far = unbalanced(0.05);
  EXPECT_LT(far.force, 0.4 * near.force);
  EXPECT_LT(near.part, 0.02);
  EXPECT_NEAR(far.part / near.part, far.force / near.force, 0.1 * far.force / near.force);
}

TEST(QuasiStaticContact, KnowsHowFastItsPointsMove) {
  const SmallDisk disk;
  QuasiStaticContact contact = contact_of(disk);
  const Pose pose = pressed(disk, 0.2);
  const PoseRate rate{-0.3, 0.7};
  constexpr double kTime = 1e-7;
  contact.take(pose);
  const PointArray now = contact.displacements(rate);
  const auto later = [&](double time) {
    QuasiStaticContact other = contact;
    other.take({pose.height + time * rate.velocity, pose.angle + time * rate.spin});
    return Eigen::ArrayXd(other.displacements(rate).col(0));
  };
  const Eigen::ArrayXd expected = (later(kTime) - later(-kTime)) / (2.0 * kTime);
  EXPECT_GT(expected.abs().maxCoeff(), 0.01);
  EXPECT_LT((now.col(1) - expected).abs().maxCoeff(), 1e-6 * expected.abs().maxCoeff());
}

/// None high above, more the deeper; those that came in stay.
TEST(QuasiStaticContact, TakesInPointsAsTheyComeWithinReach) {
  const SmallDisk disk;
  QuasiStaticContact contact = contact_of(disk);
  Pose pose = pressed(disk);
  contact.take({pose.height + 1.0, 0.0});
  EXPECT_TRUE(contact.points().empty());
  EXPECT_EQ(contact.force(), 0.0);
  EXPECT_EQ(contact.torque(), 0.0);
  EXPECT_EQ(contact.largest_force(), 0.0);
  contact.take({pose.height + 0.07, 0.0});
  const std::size_t few = contact.points().size();
  EXPECT_GE(few, 1U);
  contact.take(pose);
  EXPECT_GT(contact.points().size(), few);
  EXPECT_LT(contact.points().size(), 30U);
}

/// Wherever the search begins.
TEST(QuasiStaticContact, DoesNotDependOnThePosesBefore) {
  const SmallDisk disk;
  const Pose pose = pressed(disk);
  QuasiStaticContact at_once = contact_of(disk);
  at_once.take({pose.height - 0.02, 0.0});
  QuasiStaticContact slowly = contact_of(disk);
  for (int k = 0; k <= 100; ++k) slowly.take({pose.height + 0.1 - 0.0012 * k, 0.0});
  EXPECT_NEAR(at_once.force(), slowly.force(), 1e-10 * slowly.force());
  EXPECT_NEAR(at_once.torque(), slowly.torque(), 1e-10 * slowly.force());
}

}  // namespace
}  // namespace impact
