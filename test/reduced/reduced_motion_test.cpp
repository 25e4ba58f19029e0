#include "reduced/reduced_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/blanes_moan.hpp"
#include "mechanics/simulation.hpp"
#include "mechanics/spectrum.hpp"
#include "small_disk.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

constexpr double kSpeed = 1e-3;
constexpr double kNegligibleEnergy = 1e-16;  // M c²

constexpr double kOutOfReach = 0.12;  // R above the wall

ReducedMotion motion_of(const SmallDisk& disk, double step, double gap = kOutOfReach) {
  return {disk.field, disk.above(gap, kSpeed), disk.compliance, kNegligibleEnergy, step};
}

constexpr double kTime = 180.0;  // R/c: to the wall and back

/// A triangle of stiff bonds that stands on one point, the centre of mass x beside it, on a wall of
/// short range: e = (k² − x²)/(k² + x²) with the radius of gyration k, from the impulse J at the
/// lever arm x: v′ = −v + J, ω = −x J/k², and the energy. In the range 1/a it turns by ω/(a v).
TEST(ReducedMotion, OfAStiffBodyHasTheRigidLimit) {
  PointArray points(3, 2);
  points << 0.0, 0.0, 1.2, 0.6, -0.4, 0.9;
  const Lattice lattice = plain_lattice(points, {{0, 1}, {0, 2}, {1, 2}});
  const PointArray arm = about_the_centre(points);
  const double x = arm(0, 0);
  const double k_squared = arm.square().sum() / 3.0;
  constexpr double kShort = 3e4;
  ForceField field{BondForces(lattice, {1e9, 0.0, 0.0}), 1.0 / 3.0};
  field.wall.emplace(kShort, 1e-4);
  State start;
  start.position = points;
  start.position.col(1) += 2e-3;
  start.velocity = PointArray::Zero(3, 2);
  start.velocity.col(1) = -kSpeed;
  ReducedMotion motion(field, start, std::make_shared<Compliance>(lattice), 1e-20,
                       0.05 / (kShort * kSpeed));
  while (motion.time() < 4.0) motion.step();
  const double e = (k_squared - x * x) / (k_squared + x * x);
  EXPECT_NEAR(motion.rate().velocity / kSpeed, e, 1e-3);
  EXPECT_NEAR(motion.rate().spin, x * (1.0 + e) * kSpeed / k_squared, 1e-3 * kSpeed);
  EXPECT_LT(std::abs(e), 0.9);
}

/// At the end and on the way, a quarter of it with half the step.
TEST(ReducedMotion, KeepsItsEnergyToTheSecondOrder) {
  const SmallDisk disk;
  const auto deviation = [&](double step) {
    ReducedMotion motion = motion_of(disk, step);
    const double before = motion.energy();
    double largest = 0.0;
    while (motion.time() < kTime) {
      motion.step();
      largest = std::max(largest, std::abs(motion.energy() / before - 1.0));
    }
    EXPECT_LT(std::abs(motion.energy() / before - 1.0), 1e-6);
    return largest;
  };
  const double coarse = deviation(0.4);
  EXPECT_LT(coarse, 2e-3);
  EXPECT_NEAR(deviation(0.2) / coarse, 0.25, 0.02);
}

/// The state of all points has the momentum, angular momentum and energies of the rigid motion.
TEST(ReducedMotion, RecoversAllPoints) {
  const SmallDisk disk;
  ReducedMotion motion = motion_of(disk, 0.2);
  while (motion.time() < 0.45 * kTime) motion.step();
  ASSERT_GT(motion.contact().force(), 1e-5);
  const BodyMotion body = body_motion(motion.state().position, motion.state().velocity);
  EXPECT_NEAR(body.centre.y(), motion.pose().height, 1e-13);
  EXPECT_NEAR(body.velocity.y(), motion.rate().velocity, 1e-15);
  EXPECT_NEAR(rigid_rotation(disk.lattice.points, motion.state().position), motion.pose().angle,
              1e-9);
  const EnergyLedger ledger = motion.ledger();
  EXPECT_NEAR(ledger.bonds, motion.contact().bond_energy(), 1e-2 * ledger.bonds);
  EXPECT_NEAR(ledger.wall + ledger.bonds, motion.contact().energy(), 1e-3 * ledger.wall);
  EXPECT_NEAR(ledger.total(), motion.energy(), 1e-3 * motion.energy());
  EXPECT_EQ(motion.field().wall->total_force().y(), motion.contact().force());
  EXPECT_EQ(motion.field().wall->largest_force(), motion.contact().largest_force());
}

/// Velocities are the rates of the positions.
TEST(ReducedMotion, RecoversVelocities) {
  const SmallDisk disk;
  constexpr double kStep = 0.01;
  constexpr double kSpin = 0.01;  // c/R: it has turned by 0.7 when it touches
  State start = disk.above(kOutOfReach, kSpeed);
  start.velocity.col(0) -= kSpin * disk.arm.col(1);
  start.velocity.col(1) += kSpin * disk.arm.col(0);
  ReducedMotion motion(disk.field, start, disk.compliance, kNegligibleEnergy, kStep);
  while (motion.time() < 0.4 * kTime) motion.step();
  ASSERT_GT(motion.contact().force(), 1e-7);
  const PointArray before = motion.state().position;
  motion.step();
  const PointArray velocity = motion.state().velocity;
  motion.step();
  const PointArray rate = (motion.state().position - before) / (2.0 * kStep);
  EXPECT_LT((rate - velocity).abs().maxCoeff(), 1e-6 * kSpeed);
}

BodyMotion full_motion(const SmallDisk& disk, double gap = kOutOfReach) {
  Simulation simulation(disk.field, disk.above(gap, kSpeed),
                        lattice_spectrum(disk.lattice, disk.field.bonds.law(), 1.0 / 60.0), 0.05,
                        std::make_unique<BlanesMoan>());
  while (simulation.time() < kTime) simulation.step();
  return body_motion(simulation.state().position, simulation.state().velocity);
}

/// To what it says of itself, which is little.
TEST(ReducedMotion, DiffersFromThatOfAllPointsByNoMoreThanItSays) {
  const SmallDisk disk;
  ReducedMotion motion = motion_of(disk, 0.02);
  while (motion.time() < kTime) motion.step();
  const BodyMotion full = full_motion(disk);
  const ModelError error = motion.model_error();
  constexpr double kOfSteps = 1e-8;
  EXPECT_LT(error.restitution, 1e-5);
  EXPECT_NEAR(motion.rate().velocity / full.velocity.y(), 1.0, error.restitution + kOfSteps);
  EXPECT_NEAR(motion.rate().spin, full.spin(), error.spin + kOfSteps * kSpeed);
  // Without the elastic displacement, or with another lever arm, it would differ by more.
  EXPECT_GT(std::abs(full.spin()), 1e3 * error.spin);
}

/// One that starts in the wall feels its force all at once, and vibrates: in a step too long for
/// what that excites the course of the force does not say so.
TEST(ReducedMotion, SaysThatItStartsInTheWall) {
  const SmallDisk disk;
  constexpr double kInReach = 0.04;
  ReducedMotion motion = motion_of(disk, 0.8, kInReach);
  ReducedMotion fine = motion_of(disk, 0.02, kInReach);
  while (motion.time() < kTime) motion.step();
  while (fine.time() < kTime) fine.step();
  const double difference = fine.rate().velocity / full_motion(disk, kInReach).velocity.y() - 1.0;
  EXPECT_GT(std::abs(difference), 1e-3);
  EXPECT_LT(std::abs(difference), motion.model_error().restitution);
}

}  // namespace
}  // namespace impact
