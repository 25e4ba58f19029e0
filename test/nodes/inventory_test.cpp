#include "nodes/inventory.hpp"

#include <gtest/gtest.h>

namespace impact {
namespace {

using lattice_impact::RunStatus;
using Lines = std::vector<std::string>;

RunStatus status(std::uint32_t run, std::uint8_t phase, std::uint32_t states,
                 std::uint32_t bodies = 1) {
  RunStatus message;
  message.run = run;
  message.runs = 2;
  message.phase = phase;
  message.states = states;
  message.bodies = bodies;
  return message;
}

void add_states(Inventory& inventory, std::uint32_t run, int count, const std::string& body = "") {
  for (int k = 0; k < count; ++k) {
    inventory.add(body + "particle_states", run);
    inventory.add(body + "contact_forces", run);
  }
}

void add_run(Inventory& inventory, std::uint32_t run) {
  inventory.add("lattice", run);
  add_states(inventory, run, 3);
  inventory.add(status(run, RunStatus::FINISHED, 3));
}

TEST(Inventory, OfAWholeSeriesHasNoProblems) {
  Inventory inventory;
  EXPECT_EQ(inventory.problems(), Lines{"there is no run"});
  add_run(inventory, 0);
  EXPECT_TRUE(inventory.has_all_of(0));
  EXPECT_EQ(inventory.problems(), Lines{"run 1 of 2 is missing"});
  add_run(inventory, 1);
  EXPECT_EQ(inventory.problems(), Lines{});
  EXPECT_EQ(inventory.published("particle_states"), 6U);
  EXPECT_EQ(inventory.published("lattice"), 2U);
  EXPECT_EQ(inventory.last_run(), 1U);
}

/// Status messages are counted by their own sequence, from 0.
TEST(Inventory, CountsTheStatusMessages) {
  Inventory inventory;
  inventory.add("lattice", 0);
  RunStatus end = status(0, RunStatus::FINISHED, 0);
  end.sequence = 2;
  inventory.add(status(0, RunStatus::RUNNING, 0));
  inventory.add(end);
  EXPECT_EQ(inventory.published("run_status"), 3U);
  EXPECT_EQ(inventory.problems(),
            (Lines{"run 0: run_status: 2 of 3 messages published", "run 1 of 2 is missing"}));
}

TEST(Inventory, NamesWhatIsMissing) {
  Inventory inventory;
  add_states(inventory, 0, 3);
  inventory.add("contact_forces", 0);
  inventory.add(status(0, RunStatus::FINISHED, 4));
  add_run(inventory, 1);
  EXPECT_FALSE(inventory.has_all_of(0));
  EXPECT_EQ(inventory.states(0), 3U);
  EXPECT_EQ(inventory.problems(), (Lines{"run 0: lattice: 0 of 1 messages published",
                                         "run 0: particle_states: 3 of 4 messages published"}));
}

TEST(Inventory, ExpectsTheTopicsOfAnElasticWallWhereThereIsOne) {
  Inventory inventory;
  inventory.add("lattice", 0);
  inventory.add("wall/lattice", 0);
  add_states(inventory, 0, 2);
  add_states(inventory, 0, 1, "wall/");
  inventory.add(status(0, RunStatus::FINISHED, 2, 2));
  add_run(inventory, 1);
  EXPECT_EQ(inventory.states(0), 1U);
  EXPECT_EQ(inventory.published("wall/particle_states"), 2U);
  EXPECT_EQ(inventory.problems(), (Lines{"run 0: wall/particle_states: 1 of 2 messages published",
                                         "run 0: wall/contact_forces: 1 of 2 messages published"}));
}

TEST(Inventory, ExpectsAllScalarsOfARunOrNone) {
  Inventory inventory;
  add_run(inventory, 0);
  inventory.add("scalars", 1);
  add_run(inventory, 1);
  EXPECT_TRUE(inventory.has_all_of(0));
  EXPECT_FALSE(inventory.has_all_of(1));
  EXPECT_EQ(inventory.states(1), 3U);  // nobody waits for them
  EXPECT_EQ(inventory.published("scalars"), 3U);
  EXPECT_EQ(inventory.problems(), Lines{"run 1: scalars: 1 of 3 messages published"});
  inventory.add("scalars", 1);
  inventory.add("scalars", 1);
  EXPECT_EQ(inventory.problems(), Lines{});
}

TEST(Inventory, TellsRunsThatDidNotEndWell) {
  Inventory inventory;
  inventory.add("lattice", 0);
  RunStatus failed = status(0, RunStatus::FAILED, 0);
  failed.error = "the step is too long";
  inventory.add(failed);
  EXPECT_EQ(inventory.last_run(), 0U);
  EXPECT_EQ(inventory.problems(), (Lines{"run 0: the step is too long", "run 1 of 2 is missing"}));

  Inventory running;
  running.add("lattice", 0);
  running.add(status(0, RunStatus::RUNNING, 0));
  add_states(running, 0, 2);
  EXPECT_EQ(running.problems().front(), "run 0: its end was not announced");
  EXPECT_EQ(running.published("particle_states"), 2U);

  Inventory without;
  without.add("lattice", 0);
  EXPECT_EQ(without.problems(), Lines{"run 0: run_status is missing"});
}

}  // namespace
}  // namespace impact
