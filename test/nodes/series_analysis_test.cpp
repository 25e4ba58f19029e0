#include "nodes/series_analysis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "nodes/checksum.hpp"
#include "small_series.hpp"

namespace impact {
namespace {

/// An analysis that keeps what it says.
struct Listener {
  SeriesAnalysis analysis{
      {[this](const lattice_impact::Strain& s) { strains.push_back(s); },
       [this](const lattice_impact::Restitution& r) { results.push_back(r); },
       [this](const ClosedRun& run) {
         closed.push_back(run);
         acknowledged_before.push_back(taken_in.back());
       },
       [this](std::uint32_t run, std::uint32_t sequence) { taken_in.emplace_back(run, sequence); },
       [this](const std::string& problem) { problems.push_back(problem); }}};
  std::vector<lattice_impact::Strain> strains;
  std::vector<lattice_impact::Restitution> results;
  std::vector<ClosedRun> closed;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> acknowledged_before;  ///< each closed run
  std::vector<std::pair<std::uint32_t, std::uint32_t>> taken_in;
  std::vector<std::string> problems;

  void hear(const std::vector<Message>& messages) {
    for (const Message& message : messages) {
      std::visit([this](const auto& m) { analysis.add(m); }, message);
    }
  }
};

double direct_restitution(const Scene& scene) {
  Run run(scene);
  ImpactAnalysis analysis(scene.gravity);
  run.show(analysis);
  while (!run.finished()) run.advance();
  run.show(analysis);
  return analysis.restitution(true).restitution;
}

Scene thrown_at_a_disk(double radius, bool mirrored) {
  Scene scene = small_scene(SceneKind::kCollision);
  scene.wall.kind = WallKind::kDisk;
  scene.wall.radius = radius;
  scene.wall.mirrored = mirrored;
  scene.impact.angle = 30.0;
  return scene;
}

Scene falling() {
  Scene scene = small_scene(SceneKind::kCollision);
  scene.gravity = 2e-3;
  return scene;
}

class AnyImpact : public testing::TestWithParam<Scene> {};

TEST_P(AnyImpact, OfMessagesEqualsTheDirectOne) {
  const Scene scene = GetParam();
  Listener listener;
  listener.hear(messages_of(scene, 0));
  ASSERT_EQ(listener.results.size(), 2U);
  EXPECT_EQ(listener.results[0].ended, 0);
  EXPECT_EQ(listener.results[0].velocity_before, listener.results[1].velocity_before);
  EXPECT_TRUE(std::isnan(listener.results[0].restitution));
  EXPECT_EQ(listener.results[1].ended, 1);
  EXPECT_EQ(listener.results[1].complete, 1);
  EXPECT_EQ(listener.results[1].restitution, direct_restitution(scene));
  EXPECT_TRUE(listener.results[1].flags.empty());
  EXPECT_TRUE(listener.problems.empty());
}

INSTANTIATE_TEST_SUITE_P(SeriesAnalysis, AnyImpact,
                         testing::Values(small_scene(SceneKind::kCollision),
                                         thrown_at_a_disk(1.5, false), thrown_at_a_disk(1.0, true),
                                         falling()));

/// The simulation's answer is drawn from several runs. It is handed on, with its errors, beside
/// what the states of this run say; where those are further off than the errors allow, it is
/// flagged.
TEST(SeriesAnalysis, HoldsTheAnswerAgainstTheStates) {
  const Scene scene = small_scene(SceneKind::kCollision);
  const double of_run = direct_restitution(scene);
  for (const bool agrees : {true, false}) {
    std::vector<Message> messages = messages_of(scene, 0);
    auto& end = std::get<lattice_impact::RunStatus>(messages.back());
    end.answer.restitution = of_run - 1e-5;
    end.answer_error.restitution = 1e-6;
    end.answer.peak_force = 0.125;
    end.restitution_of_run_error = agrees ? 1.1e-5 : 0.9e-5;
    Listener listener;
    listener.hear(messages);
    const lattice_impact::Restitution& result = listener.results.back();
    EXPECT_EQ(result.restitution, of_run - 1e-5);
    EXPECT_EQ(result.error.restitution, 1e-6);
    EXPECT_EQ(result.peak_force, 0.125);
    EXPECT_DOUBLE_EQ(result.velocity_after, 0.05 * (of_run - 1e-5));
    EXPECT_EQ(result.restitution_of_run, of_run);
    EXPECT_EQ(result.restitution_of_run_error, end.restitution_of_run_error);
    const std::vector<std::string> flags(agrees ? 0 : 1, "disagrees");
    EXPECT_EQ(result.flags, flags);
    EXPECT_EQ(listener.closed[0].answer, of_run - 1e-5);
  }
}

/// Where the simulation knows no error, the states have its answer to the last bit.
TEST(SeriesAnalysis, FlagsAnyDifferenceFromAnAnswerWithoutError) {
  std::vector<Message> messages = messages_of(small_scene(SceneKind::kCollision), 0);
  std::get<lattice_impact::RunStatus>(messages.back()).answer.restitution += 1e-15;
  Listener listener;
  listener.hear(messages);
  EXPECT_EQ(listener.results.back().flags, std::vector<std::string>{"disagrees"});
}

/// Topics have no order among each other: all of one topic, then all of the next.
TEST(SeriesAnalysis, DoesNotDependOnTheOrderOfTopics) {
  const Scene scene = small_scene(SceneKind::kCollision);
  const std::vector<Message> messages = messages_of(scene, 0);
  Listener usual;
  usual.hear(messages);
  for (const bool backwards : {false, true}) {
    std::vector<Message> sorted = messages;
    std::stable_sort(sorted.begin(), sorted.end(), [&](const Message& a, const Message& b) {
      return backwards ? a.index() > b.index() : a.index() < b.index();
    });
    Listener listener;
    listener.hear(sorted);
    ASSERT_EQ(listener.results.size(), 2U);
    EXPECT_EQ(listener.results[1].restitution, usual.results[1].restitution);
    EXPECT_EQ(listener.strains, usual.strains);
  }
}

TEST(SeriesAnalysis, KeepsTheRunsOfASeriesApart) {
  Scene scene = small_scene(SceneKind::kCollision);
  std::vector<Message> messages = messages_of(scene, 0);
  scene.impact.velocity = 0.1;
  const std::vector<Message> second = messages_of(scene, 1);
  // The second run begins to arrive before the first one's last words.
  messages.insert(messages.end() - 1, second.begin(), second.end() - 1);
  messages.push_back(second.back());
  Listener listener;
  listener.hear(messages);
  ASSERT_EQ(listener.results.size(), 4U);
  EXPECT_EQ(listener.results[2].run, 0U);
  EXPECT_NEAR(listener.results[2].velocity_before, -0.05, 1e-15);
  EXPECT_EQ(listener.results[3].run, 1U);
  EXPECT_NEAR(listener.results[3].velocity_before, -0.1, 1e-15);
  EXPECT_TRUE(listener.analysis.done());
}

/// The last run, or one that failed, is the end.
TEST(SeriesAnalysis, IsDoneAfterTheLastRun) {
  const Scene scene = small_scene(SceneKind::kCollision);
  Listener listener;
  listener.hear(messages_of(scene, 0));
  EXPECT_FALSE(listener.analysis.done());
  listener.hear(messages_of(scene, 1));
  EXPECT_TRUE(listener.analysis.done());
}

/// A run that was given up has no answer.
TEST(SeriesAnalysis, GivesNoNumberForARunThatWasGivenUp) {
  for (const auto& [kind, flag] : {std::make_pair(SceneKind::kCollision, "not_separated"),
                                   std::make_pair(SceneKind::kContact, "not_at_rest")}) {
    std::vector<Message> messages = messages_of(small_scene(kind), 0);
    std::get<lattice_impact::RunStatus>(messages.back()).flags.emplace_back(flag);
    Listener listener;
    listener.hear(messages);
    ASSERT_EQ(listener.closed.size(), 1U);
    EXPECT_TRUE(std::isnan(listener.closed[0].answer)) << flag;
    for (const auto& strain : listener.strains) EXPECT_EQ(strain.at_rest, 0);
    for (const auto& result : listener.results) EXPECT_EQ(result.complete, 0);
    EXPECT_TRUE(listener.problems.empty());
  }
}

TEST(SeriesAnalysis, SaysWhatRestsAndAcknowledgesTheEnd) {
  Listener listener;
  listener.hear(messages_of(small_scene(SceneKind::kContact), 0));
  EXPECT_TRUE(listener.results.empty());
  ASSERT_GT(listener.strains.size(), 2U);
  const lattice_impact::Strain& last = listener.strains.back();
  const lattice_impact::Strain& before = *(listener.strains.end() - 2);
  EXPECT_EQ(last.at_rest, 1);
  EXPECT_EQ(before.at_rest, 0);
  EXPECT_EQ(last.strain, before.strain);
  EXPECT_EQ(last.sequence, before.sequence + 1);
  EXPECT_GT(last.strain, 0.0);
  EXPECT_EQ(listener.taken_in.back().second, before.sequence + 1);
}

TEST(SeriesAnalysis, HandsOnTheAnswerOfAClosedRun) {
  const Scene scene = small_scene(SceneKind::kCollision);
  Listener listener;
  listener.hear(messages_of(scene, 3));
  ASSERT_EQ(listener.closed.size(), 1U);
  EXPECT_EQ(listener.closed[0].number, 3U);
  EXPECT_EQ(listener.closed[0].answer, listener.results.back().restitution);
  EXPECT_EQ(to_yaml(listener.closed[0].scene), to_yaml(scene));

  Listener pressed;
  pressed.hear(messages_of(small_scene(SceneKind::kContact), 0));
  ASSERT_EQ(pressed.closed.size(), 1U);
  EXPECT_EQ(pressed.closed[0].answer, pressed.strains.back().strain);
}

/// What is made of a closed run is out before its end is acknowledged.
TEST(SeriesAnalysis, HandsOnAClosedRunBeforeItsEndIsAcknowledged) {
  Listener listener;
  listener.hear(messages_of(small_scene(SceneKind::kCollision), 0));
  ASSERT_EQ(listener.acknowledged_before.size(), 1U);
  EXPECT_EQ(listener.acknowledged_before[0].second + 1, listener.taken_in.back().second);
}

TEST(SeriesAnalysis, HasARunOpenFromItsFirstMessageUntilItsEndIsAcknowledged) {
  std::vector<bool> open;
  SeriesAnalysis* asked = nullptr;
  SeriesAnalysis analysis(
      {[](const auto&) {}, [](const auto&) {}, [](const auto&) {},
       [&](std::uint32_t run, std::uint32_t) { open.push_back(asked->is_open(run)); },
       [](const auto&) {}});
  asked = &analysis;
  EXPECT_FALSE(analysis.is_open(0));
  for (const Message& message : messages_of(small_scene(SceneKind::kCollision), 0)) {
    std::visit([&](const auto& content) { analysis.add(content); }, message);
  }
  ASSERT_GT(open.size(), 2U);
  EXPECT_FALSE(open.back());
  open.pop_back();
  EXPECT_TRUE(std::all_of(open.begin(), open.end(), [](bool is) { return is; }));
}

/// One state is lost: no number is given, and it is said why.
TEST(SeriesAnalysis, ReportsAGap) {
  std::vector<Message> messages = messages_of(small_scene(SceneKind::kCollision), 0);
  messages.erase(messages.begin() + 10);
  Listener listener;
  listener.hear(messages);
  ASSERT_EQ(listener.results.size(), 2U);
  EXPECT_EQ(listener.results[1].complete, 0);
  EXPECT_TRUE(std::isnan(listener.results[1].restitution));
  EXPECT_EQ(listener.results[1].flags, std::vector<std::string>{"incomplete"});
  ASSERT_EQ(listener.closed.size(), 1U);
  EXPECT_TRUE(std::isnan(listener.closed[0].answer));
  ASSERT_EQ(listener.problems.size(), 1U);
  EXPECT_EQ(listener.problems[0], "run 0: messages are missing: expected sequence 4, got 5");
}

/// A run that misses messages is given up without the next one, which goes on.
TEST(SeriesAnalysis, ClosesOnlyWhatHasEnded) {
  std::vector<Message> first = messages_of(small_scene(SceneKind::kCollision), 0);
  first.erase(first.end() - 2);
  std::vector<Message> second = messages_of(small_scene(SceneKind::kCollision), 1);
  const auto middle = second.begin() + static_cast<std::ptrdiff_t>(second.size() / 2);
  Listener listener;
  listener.hear(first);
  listener.hear({second.begin(), middle});
  listener.analysis.close_ended();
  EXPECT_FALSE(listener.analysis.waits_for_missing());
  ASSERT_EQ(listener.problems.size(), 1U);
  EXPECT_EQ(listener.problems[0].substr(0, 18), "run 0: incomplete ");
  listener.hear({middle, second.end()});
  EXPECT_EQ(listener.problems.size(), 1U);
  EXPECT_TRUE(listener.results.back().ended);
  EXPECT_TRUE(listener.results.back().complete);
  EXPECT_EQ(listener.results.back().run, 1U);
}

/// The last state is lost: the run stays open until it is closed from outside.
TEST(SeriesAnalysis, WaitsForMissingMessages) {
  std::vector<Message> messages = messages_of(small_scene(SceneKind::kCollision), 0);
  messages.erase(messages.end() - 2);
  Listener listener;
  listener.hear(messages);
  EXPECT_EQ(listener.results.size(), 1U);
  EXPECT_TRUE(listener.analysis.waits_for_missing());
  listener.analysis.close();
  EXPECT_FALSE(listener.analysis.waits_for_missing());
  ASSERT_EQ(listener.results.size(), 2U);
  EXPECT_EQ(listener.results[1].complete, 0);
  EXPECT_EQ(listener.problems.size(), 1U);
}

using States = lattice_impact::ParticleStates;
using Forces = lattice_impact::ContactForces;

struct Damage {
  const char* name;
  std::function<void(std::vector<Message>&)> done_to;
  const char* told;  ///< in the problem
};

template <class Type>
Type& nth(std::vector<Message>& messages, int n) {
  for (Message& message : messages) {
    if (std::holds_alternative<Type>(message) && n-- == 0) return std::get<Type>(message);
  }
  throw std::out_of_range("no such message");
}

template <class Type>
std::function<void(std::vector<Message>&)> to(int n, std::function<void(Type&)> change) {
  return [=](std::vector<Message>& messages) { change(nth<Type>(messages, n)); };
}

void no_rebound(std::vector<Message>& messages) {
  const auto came_off = [](const Message& message) {
    const auto* states = std::get_if<States>(&message);
    return states != nullptr && states->sequence > 3;
  };
  const auto end = std::get<lattice_impact::RunStatus>(messages.back());
  messages.erase(std::find_if(messages.begin(), messages.end(), came_off), messages.end());
  messages.emplace_back(end);
  std::get<lattice_impact::RunStatus>(messages.back()).states = 4;
}

class Damaged : public testing::TestWithParam<Damage> {};

/// One thing is wrong in the first of two runs: that is told, the run has no number, and the other
/// one keeps its own.
TEST_P(Damaged, RunHasNoNumberAndTheOtherKeepsIts) {
  const Scene scene = small_scene(SceneKind::kCollision);
  std::vector<Message> messages = messages_of(scene, 0);
  GetParam().done_to(messages);
  Listener listener;
  listener.hear(messages);
  listener.hear(messages_of(scene, 1));
  ASSERT_EQ(listener.problems.size(), 1U);
  EXPECT_NE(listener.problems[0].find("run 0: damaged: "), std::string::npos);
  EXPECT_NE(listener.problems[0].find(GetParam().told), std::string::npos) << listener.problems[0];
  ASSERT_EQ(listener.closed.size(), 2U);
  EXPECT_TRUE(std::isnan(listener.closed[0].answer));
  EXPECT_EQ(listener.closed[1].answer, direct_restitution(scene));
  for (const auto& result : listener.results) {
    if (result.run != 0 || result.ended == 0) continue;
    EXPECT_EQ(result.flags, std::vector<std::string>{"damaged"});
    for (const auto& [name, number] : impact_numbers<lattice_impact::Restitution>()) {
      EXPECT_TRUE(std::isnan(result.*number)) << name;
    }
    EXPECT_TRUE(std::isnan(result.velocity_before));
  }
}

constexpr double kOdd = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Of, Damaged,
    testing::Values(
        Damage{"AnEmptyLattice", to<lattice_impact::Lattice>(0, [](auto& m) { m = {}; }),
               "0 points"},
        Damage{"ABondOfAPointThatIsNotThere",
               to<lattice_impact::Lattice>(0, [](auto& m) { m.bond_second[3] = 4000000000U; }),
               "bond 3 joins"},
        Damage{"AnEmptyState", to<States>(5, [](auto& m) { m.x = m.y = m.vx = m.vy = {}; }),
               "contact_forces 5: x has 0 values for 40"},
        Damage{"AStateOfOnePointLess", to<States>(5, [](auto& m) { m.vy.pop_back(); }),
               "vy has 39 values"},
        Damage{"AStateOfOnePointMore", to<States>(5, [](auto& m) { m.x.push_back(0.0); }),
               "x has 41 values"},
        Damage{"ANumberThatIsNone", to<States>(9, [](auto& m) { m.vy[7] = kOdd; }), "vy[7] = nan"},
        Damage{"AVelocityOfAnotherRun", to<States>(9, [](auto& m) { m.vy[7] += 0.1; }),
               "the momentum changes by"},
        Damage{"AnotherSpeedAtTheStart",
               to<States>(0,
                          [](auto& m) {
                            for (double& v : m.vy) v *= 1.01;
                          }),
               "of the scene"},
        Damage{"HalfOfTheSamples",
               to<Forces>(9,
                          [](auto& m) {
                            m.sample_time.resize(m.sample_time.size() / 2);
                            m.sample_force.resize(m.sample_time.size());
                          }),
               "samples of"},
        Damage{"AnotherForce", to<Forces>(9, [](auto& m) { m.sample_force[1] += 0.01; }),
               "of the samples"},
        Damage{"ASampleThatGoesBack",
               to<Forces>(9, [](auto& m) { std::swap(m.sample_time[0], m.sample_time[1]); }),
               "a sample of"},
        Damage{"ASampleTwice", to<Forces>(9, [](auto& m) { m.sample_time[1] = m.sample_time[0]; }),
               "a sample of"},
        Damage{"ARunAfterTheLast",
               to<lattice_impact::RunStatus>(1, [](auto& m) { m.runs = m.run; }), "run 0 of 0"},
        Damage{"AnotherTime", to<Forces>(9, [](auto& m) { m.time += 1e-9; }), "of the forces"},
        Damage{"AnotherStep", to<States>(9, [](auto& m) { ++m.step; }), "of the forces"},
        Damage{"AForceOnAPointThatIsNotThere",
               to<Forces>(9,
                          [](auto& m) {
                            m.point.push_back(40);
                            m.fx.push_back(0.0);
                            m.fy.push_back(0.0);
                          }),
               "a point that is not there"},
        Damage{"APhaseThatIsNone", to<lattice_impact::RunStatus>(1, [](auto& m) { m.phase = 9; }),
               "phase 9"},
        Damage{"ASceneThatIsNone",
               to<lattice_impact::RunStatus>(0, [](auto& m) { m.scene = "{scene: [}"; }),
               "scene:1: "},
        Damage{"AnotherSceneAtTheEnd",
               to<lattice_impact::RunStatus>(
                   1, [](auto& m) { m.scene.replace(m.scene.find("a: 300"), 6, "a: 301"); }),
               "not the scene of the status before"},
        Damage{"FewerStatesAnnounced",
               to<lattice_impact::RunStatus>(1, [](auto& m) { m.states -= 1; }), "announced"},
        Damage{"MoreBodiesThanCanBe",
               to<lattice_impact::RunStatus>(1, [](auto& m) { m.bodies = 9; }), "9 bodies"},
        Damage{"BodiesOfAnotherScene",
               to<lattice_impact::RunStatus>(1, [](auto& m) { m.bodies = 2; }),
               "2 bodies, of the scene 1"},
        Damage{"NoRebound", no_rebound, "the disk has not come off"},
        Damage{"NoAnswer",
               to<lattice_impact::RunStatus>(1, [](auto& m) { m.answer.restitution = kOdd; }),
               "finished, with the restitution nan"}),
    [](const auto& info) { return info.param.name; });

/// The last bit of a number, in which nothing else could see a fault.
TEST(SeriesAnalysis, SeesByTheChecksumWhatIsNotAsItWasPublished) {
  const std::vector<Message> messages = messages_of(small_scene(SceneKind::kCollision), 0);
  std::uint64_t sum = checksum_of(std::get<lattice_impact::Lattice>(messages.front()));
  for (const Message& message : messages) {
    if (const auto* states = std::get_if<States>(&message)) sum += checksum_of(*states);
    if (const auto* forces = std::get_if<Forces>(&message)) sum += checksum_of(*forces);
  }
  for (const int damage : {0, 1, 2}) {
    std::vector<Message> changed = messages;
    auto& end = std::get<lattice_impact::RunStatus>(changed.back());
    end.checksum = checksum_with(sum, end);
    double& number = damage == 2 ? end.answer.restitution : nth<States>(changed, 9).x[3];
    if (damage != 0) number = std::nextafter(number, 2.0);
    Listener listener;
    listener.hear(changed);
    EXPECT_EQ(listener.results.back().complete, damage == 0 ? 1 : 0);
    EXPECT_EQ(listener.problems.size(), damage == 0 ? 0U : 1U);
  }
}

TEST(SeriesAnalysis, GivesNoNumberForAnInterruptedRun) {
  std::vector<Message> messages = messages_of(small_scene(SceneKind::kCollision), 0);
  std::get<lattice_impact::RunStatus>(messages.back()).phase =
      lattice_impact::RunStatus::INTERRUPTED;
  Listener listener;
  listener.hear(messages);
  EXPECT_EQ(listener.results.back().complete, 0);
  EXPECT_EQ(listener.results.back().flags, std::vector<std::string>{"interrupted"});
  EXPECT_TRUE(listener.analysis.done());
}

}  // namespace
}  // namespace impact
