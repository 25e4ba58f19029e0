#include "kernels/in_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>
#include <thread>
#include <vector>

#include "mechanics/force_field.hpp"
#include "mechanics/kick.hpp"
#include "mechanics/velocity_verlet.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

TEST(InParts, CoversEveryPointOnce) {
  for (const Eigen::Index points : {0, 1, 2048, 2049, 140000}) {
    std::vector<int> visits(static_cast<std::size_t>(points), 0);
    in_parts(points, [&](Eigen::Index part, Eigen::Index first, Eigen::Index size) {
      EXPECT_EQ(first, part * kPart);
      for (Eigen::Index i = first; i < first + size; ++i) ++visits[static_cast<std::size_t>(i)];
    });
    EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0), points);
  }
}

/// How many parts, each slow enough for another thread to come, are not done by the calling one.
int parts_elsewhere() {
  std::atomic<int> elsewhere{0};
  const auto here = std::this_thread::get_id();
  in_parts(200000, [&](Eigen::Index /*part*/, Eigen::Index /*first*/, Eigen::Index /*size*/) {
    std::this_thread::sleep_for(std::chrono::microseconds(100));
    if (std::this_thread::get_id() != here) ++elsewhere;
  });
  return elsewhere;
}

/// As in the workers of a sweep.
TEST(InParts, StaysOnTheCallingThreadWhereOnlyOneIsAllowed) {
  const int threads = threads_in_a_run();
  threads_in_a_run() = 1;
  EXPECT_EQ(parts_elsewhere(), 0);
  threads_in_a_run() = threads;
}

/// Sooner or later; on a machine with one processor there is no other thread.
TEST(InParts, SharesOutToAnotherThread) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP();
  int elsewhere = 0;
  for (int k = 0; k < 1000 && elsewhere == 0; ++k) elsewhere = parts_elsewhere();
  EXPECT_GT(elsewhere, 0);
}

/// A step of a lattice large enough for several threads.
TEST(InParts, TheNumberOfThreadsDoesNotChangeABit) {
  struct Outcome {
    PointArray position, velocity, force;
    double lost, wall;
  };
  const Lattice lattice = triangular_patch(400, 350);
  const auto step = [&](int threads) {
    threads_in_a_run() = threads;
    ForceField field{BondForces(lattice, {1.0, 0.5, 0.1}), 1.0};
    field.wall.emplace(3.0, 2.0);
    const PointArray wave = (7.0 * lattice.points).sin();
    Outcome outcome{lattice.points + 0.1 * wave, wave, lattice.points, 0.0, 0.0};
    outcome.lost = field.evaluate(outcome.position, outcome.velocity, outcome.force).dissipated;
    outcome.wall = field.wall->total_force().y();
    kick_and_drift(0.1, outcome.force, 0.2, outcome.velocity, outcome.position);
    kick(0.3, outcome.force, outcome.velocity);
    return outcome;
  };
  const int threads = threads_in_a_run();
  const Outcome by_one = step(1);
  const Outcome by_three = step(3);
  threads_in_a_run() = threads;
  EXPECT_TRUE((by_one.force == by_three.force).all());
  EXPECT_TRUE((by_one.position == by_three.position).all());
  EXPECT_TRUE((by_one.velocity == by_three.velocity).all());
  EXPECT_EQ(by_one.lost, by_three.lost);
  EXPECT_EQ(by_one.wall, by_three.wall);
  EXPECT_GT(by_one.wall, 1.0);
}

/// Each part is put in its place once, and worked on once when all that it needs is there.
TEST(InPassing, PlacesEachPartOnceBeforeItIsNeeded) {
  const int threads = threads_in_a_run();
  for (const int allowed : {1, 3}) {
    threads_in_a_run() = allowed;
    for (const Eigen::Index parts : {0, 1, 5, 64, 200}) {
      for (const Eigen::Index reach : {0, 1, 3, 30}) {
        PartsNeeded needed;
        for (Eigen::Index part = 0; part < parts; ++part) {
          needed.begin.push_back(std::max<Eigen::Index>(0, part - reach));
          needed.end.push_back(std::min(parts, part + reach + 1));
        }
        std::vector<std::atomic<int>> placed(static_cast<std::size_t>(parts));
        std::vector<std::atomic<int>> done(static_cast<std::size_t>(parts));
        in_passing(
            parts, needed, [&](Eigen::Index part) { ++placed[static_cast<std::size_t>(part)]; },
            [&](Eigen::Index part) {
              const auto p = static_cast<std::size_t>(part);
              for (Eigen::Index k = needed.begin[p]; k < needed.end[p]; ++k) {
                EXPECT_EQ(placed[static_cast<std::size_t>(k)], 1);
              }
              ++done[p];
            });
        for (const auto& count : placed) EXPECT_EQ(count, 1);
        for (const auto& count : done) EXPECT_EQ(count, 1);
      }
    }
  }
  threads_in_a_run() = threads;
}

/// A step in one pass, on any number of threads, is a step in three.
TEST(InPassing, MakesTheStepOfSeparateLoops) {
  const Lattice lattice = triangular_patch(400, 350);
  const PointArray wave = (7.0 * lattice.points).sin();
  const auto start = [&] { return State{0.0, 0, lattice.points + 0.1 * wave, wave}; };
  const auto make_field = [&] {
    ForceField field{BondForces(lattice, {1.0, 0.5, 0.0}), 1.0};
    field.wall.emplace(3.0, 2.0);
    return field;
  };
  State expected = start();
  ForceField field = make_field();
  PointArray force = wave;
  field.evaluate(expected.position, expected.velocity, force);
  kick_and_drift(0.05, force, 0.1, expected.velocity, expected.position);
  field.evaluate(expected.position, expected.velocity, force);
  kick(0.05, force, expected.velocity);
  const int threads = threads_in_a_run();
  for (const int allowed : {1, 3}) {
    threads_in_a_run() = allowed;
    State state = start();
    ForceField in_passing = make_field();
    VelocityVerlet verlet;
    verlet.restart(in_passing, state);
    verlet.step(in_passing, state, 0.1);
    EXPECT_TRUE((state.position == expected.position).all());
    EXPECT_TRUE((state.velocity == expected.velocity).all());
    EXPECT_EQ(in_passing.wall->total_force().y(), field.wall->total_force().y());
    EXPECT_EQ(in_passing.evaluations, field.evaluations);
  }
  threads_in_a_run() = threads;
}

}  // namespace
}  // namespace impact
