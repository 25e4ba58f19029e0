#include "nodes/conversions.hpp"

#include <gtest/gtest.h>

#include "lattice/placement.hpp"

namespace impact {
namespace {

TEST(Conversions, LatticeRoundTripKeepsEveryBit) {
  const Lattice lattice = triangulated_lattice(place_in_disk({200}, 1));
  const Lattice again = from_message(to_message(lattice));
  EXPECT_TRUE((again.points == lattice.points).all());
  EXPECT_EQ(again.bonds, lattice.bonds);
  EXPECT_EQ(again.natural_lengths, lattice.natural_lengths);
}

TEST(Conversions, StateRoundTripKeepsEveryBit) {
  State state{1.0 / 3.0, 17, place_in_disk({50}, 1), place_in_disk({50}, 2)};
  const State again = from_message(to_message(state));
  EXPECT_EQ(again.time, state.time);
  EXPECT_EQ(again.step, state.step);
  EXPECT_TRUE((again.position == state.position).all());
  EXPECT_TRUE((again.velocity == state.velocity).all());
}

TEST(Conversions, ContactReportRoundTripKeepsEveryBit) {
  ContactReport report;
  report.time = 0.1;
  report.step = 3;
  report.points = {{4, {0.0, 1.0 / 7.0}}, {9, {0.5, 0.25}}};
  report.total = {0.5, 0.25 + 1.0 / 7.0};
  report.impulse = 0.3;
  report.peak_force = 0.7;
  report.samples = {{0.05, 0.7}, {0.1, 0.4}};
  const ContactReport again = from_message(to_message(report));
  EXPECT_EQ(again.time, report.time);
  EXPECT_EQ(again.step, report.step);
  ASSERT_EQ(again.points.size(), 2U);
  EXPECT_EQ(again.points[1].point, 9);
  EXPECT_TRUE((again.points[0].force == report.points[0].force).all());
  EXPECT_TRUE((again.total == report.total).all());
  EXPECT_EQ(again.impulse, report.impulse);
  EXPECT_EQ(again.peak_force, report.peak_force);
  ASSERT_EQ(again.samples.size(), 2U);
  EXPECT_EQ(again.samples[1].time, 0.1);
  EXPECT_EQ(again.samples[1].force, 0.4);
}

TEST(Conversions, IntoTheSameMessageLeaveNothingOfTheOneBefore) {
  ContactReport report;
  report.points = {{4, {0.0, 0.5}}, {9, {0.5, 0.25}}};
  report.samples = {{0.05, 0.7}, {0.1, 0.4}};
  lattice_impact::ContactForces forces = to_message(report);
  report.points.pop_back();
  report.samples.pop_back();
  to_message(report, forces);
  EXPECT_EQ(from_message(forces).points.size(), 1U);
  EXPECT_EQ(from_message(forces).samples.size(), 1U);
}

/// Each energy is its own: powers of two, whose sum tells them apart.
TEST(Conversions, OfALedgerKeepEveryEnergy) {
  EnergyLedger ledger;
  ledger.kinetic_translation = 1.0;
  ledger.kinetic_rotation = 2.0;
  ledger.kinetic_internal = 4.0;
  ledger.bonds = 8.0;
  ledger.wall = 16.0;
  ledger.load = 32.0;
  ledger.dissipated = 64.0;
  ledger.wall_lattice = 128.0;
  ledger.absorbed = 256.0;
  ledger.hops = 512.0;
  ledger.hops_size = 1024.0;
  const auto expect_all = [](const auto& message) {
    EXPECT_EQ(message.kinetic_translation, 1.0);
    EXPECT_EQ(message.kinetic_rotation, 2.0);
    EXPECT_EQ(message.kinetic_internal, 4.0);
    EXPECT_EQ(message.bonds, 8.0);
    EXPECT_EQ(message.wall, 16.0);
    EXPECT_EQ(message.load, 32.0);
    EXPECT_EQ(message.dissipated, 64.0);
    EXPECT_EQ(message.wall_lattice, 128.0);
    EXPECT_EQ(message.absorbed, 256.0);
    EXPECT_EQ(message.hops, 512.0);
    EXPECT_EQ(message.hops_size, 1024.0);
    EXPECT_EQ(message.total, 1023.0);
    EXPECT_EQ(message.error, 0.5);
  };
  expect_all(to_message(ledger, 0.5));
  expect_all(to_message(BodyMotion{}, ContactReport{}, ledger, 0.5));
}

TEST(Conversions, RefuseMessagesThatDoNotFitTogether) {
  lattice_impact::ParticleStates states =
      to_message(State{0.0, 0, place_in_disk({5}, 1), place_in_disk({5}, 2)});
  states.vy.pop_back();
  EXPECT_THROW(from_message(states), std::runtime_error);

  lattice_impact::Lattice lattice = to_message(triangulated_lattice(place_in_disk({5}, 1)));
  lattice.bond_second[0] = 5;
  EXPECT_THROW(from_message(lattice), std::runtime_error);
  lattice.natural_length.pop_back();
  EXPECT_THROW(from_message(lattice), std::runtime_error);

  lattice_impact::ContactForces forces;
  forces.point.push_back(1);
  EXPECT_THROW(from_message(forces), std::runtime_error);
}

}  // namespace
}  // namespace impact
