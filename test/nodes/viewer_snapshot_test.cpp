#include "nodes/viewer_snapshot.hpp"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>

namespace impact {
namespace {

constexpr std::size_t kPoints = 2;

lattice_impact::LatticeConstPtr lattice(std::uint32_t run, const char* name = "disk") {
  auto message = boost::make_shared<lattice_impact::Lattice>();
  message->run = run;
  message->name = name;
  message->x = message->y = {0.0, 1.0};
  message->bond_first = {0};
  message->bond_second = {1};
  message->natural_length = {1.0};
  return message;
}

lattice_impact::ParticleStatesPtr states(std::uint32_t run, std::uint32_t sequence) {
  auto message = boost::make_shared<lattice_impact::ParticleStates>();
  message->run = run;
  message->sequence = sequence;
  message->x = message->y = message->vx = message->vy = std::vector<double>(kPoints);
  return message;
}

lattice_impact::ContactForcesPtr forces(std::uint32_t run, std::uint32_t sequence) {
  auto message = boost::make_shared<lattice_impact::ContactForces>();
  message->run = run;
  message->sequence = sequence;
  return message;
}

lattice_impact::RunStatusConstPtr status(std::uint32_t run, std::uint32_t bodies = 1) {
  auto message = boost::make_shared<lattice_impact::RunStatus>();
  message->run = run;
  message->bodies = bodies;
  return message;
}

SnapshotAssembly begun(std::uint32_t run) {
  SnapshotAssembly assembly;
  assembly.add(lattice(run));
  assembly.add(status(run));
  return assembly;
}

void add_state(SnapshotAssembly& assembly, std::uint32_t run, std::uint32_t sequence) {
  assembly.add(0, states(run, sequence));
  assembly.add(forces(run, sequence));
}

TEST(SnapshotAssembly, GivesTheNewestStateOnce) {
  SnapshotAssembly assembly = begun(0);
  add_state(assembly, 0, 0);
  add_state(assembly, 0, 1);
  assembly.add(0, states(0, 2));
  auto newest = assembly.take();
  ASSERT_TRUE(newest);
  EXPECT_EQ(newest->disk.states->sequence, 1U);
  EXPECT_EQ(newest->forces->sequence, 1U);
  EXPECT_FALSE(assembly.take());
  assembly.add(forces(0, 2));
  newest = assembly.take();
  ASSERT_TRUE(newest);
  EXPECT_EQ(newest->disk.states->sequence, 2U);
}

TEST(SnapshotAssembly, GivesTheLastStateAgainWithTheEndOfTheRun) {
  SnapshotAssembly assembly = begun(0);
  add_state(assembly, 0, 5);
  EXPECT_TRUE(assembly.take());
  const auto end = status(0);
  assembly.add(end);
  const auto again = assembly.take();
  ASSERT_TRUE(again);
  EXPECT_EQ(again->disk.states->sequence, 5U);
  EXPECT_EQ(again->status, end);
}

TEST(SnapshotAssembly, GivesNothingThatDoesNotFit) {
  SnapshotAssembly assembly = begun(0);
  add_state(assembly, 1, 0);  // of another run than the lattice
  EXPECT_FALSE(assembly.take());
  const auto short_of_a_point = states(0, 0);
  short_of_a_point->vy.pop_back();
  assembly.add(0, short_of_a_point);
  assembly.add(forces(0, 0));
  EXPECT_FALSE(assembly.take());
  const auto beyond = forces(0, 1);
  beyond->point = {kPoints};
  beyond->fx = beyond->fy = {0.0};
  assembly.add(beyond);
  assembly.add(0, states(0, 1));
  EXPECT_FALSE(assembly.take());
  const auto bad = boost::make_shared<lattice_impact::Lattice>(*lattice(0));
  bad->bond_second = {kPoints};
  assembly.add(bad);
  add_state(assembly, 0, 2);
  EXPECT_FALSE(assembly.take());
}

/// The next run's status comes before its lattice.
TEST(SnapshotAssembly, GivesNoStateWithTheStatusOfAnotherRun) {
  SnapshotAssembly assembly = begun(0);
  add_state(assembly, 0, 0);
  assembly.add(status(1));
  EXPECT_FALSE(assembly.take());
  assembly.add(status(0));
  EXPECT_TRUE(assembly.take());
}

TEST(SnapshotAssembly, WaitsForAllBodies) {
  SnapshotAssembly assembly = begun(0);
  assembly.add(status(0, 3));
  assembly.add(lattice(0, "wall"));
  assembly.add(lattice(0, "wall2"));
  add_state(assembly, 0, 0);
  EXPECT_FALSE(assembly.take());
  assembly.add(2, states(0, 0));
  EXPECT_FALSE(assembly.take());
  assembly.add(1, states(0, 0));
  const auto newest = assembly.take();
  ASSERT_TRUE(newest);
  ASSERT_EQ(newest->others.size(), 2U);
  EXPECT_EQ(newest->others[0].lattice->name, "wall");
  EXPECT_EQ(newest->others[1].lattice->name, "wall2");
}

TEST(SnapshotAssembly, TakesASimulationThatBeginsAnew) {
  SnapshotAssembly assembly = begun(0);
  add_state(assembly, 0, 500);
  EXPECT_TRUE(assembly.take());
  assembly.add(lattice(0));
  assembly.add(status(0));
  add_state(assembly, 0, 0);
  const auto newest = assembly.take();
  ASSERT_TRUE(newest);
  EXPECT_EQ(newest->disk.states->sequence, 0U);
}

TEST(SnapshotAssembly, KeepsNoMoreThanItNeeds) {
  SnapshotAssembly assembly = begun(0);
  const auto first = states(0, 0);
  assembly.add(0, first);
  for (std::uint32_t k = 1; k < 100; ++k) assembly.add(0, states(0, k));
  EXPECT_EQ(first.use_count(), 1);
  assembly.add(forces(0, 99));
  EXPECT_TRUE(assembly.take());
}

}  // namespace
}  // namespace impact
