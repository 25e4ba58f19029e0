#include "nodes/series_analysis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "run/run.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

using Message = std::variant<lattice_impact::Lattice, lattice_impact::ParticleStates,
                             lattice_impact::ContactForces, lattice_impact::RunStatus>;

Scene small_scene(SceneKind kind) {
  Scene scene;
  scene.kind = kind;
  scene.disk.recipe.points = 40;
  scene.output.period = 0.2;
  if (kind == SceneKind::kCollision) {
    scene.impact.velocity = 0.05;
  } else {
    scene.material.eta = 20.0;
    scene.load.p = 0.01;
  }
  return scene;
}

lattice_impact::RunStatus status_of(const Scene& scene, std::uint32_t run, std::uint32_t states,
                                    std::uint8_t phase) {
  lattice_impact::RunStatus status;
  status.run = run;
  status.runs = 2;
  status.states = states;
  status.phase = phase;
  status.scene = to_yaml(scene);
  return status;
}

/// The messages of one run, in the order in which the simulation node sends them.
std::vector<Message> messages_of(const Scene& scene, std::uint32_t number) {
  Run run(scene);
  std::vector<Message> messages;
  lattice_impact::Lattice lattice = to_message(run.lattice());
  lattice.run = number;
  messages.emplace_back(lattice);
  messages.emplace_back(status_of(scene, number, 0, lattice_impact::RunStatus::RUNNING));
  std::uint32_t sequence = 0;
  ImpactAnalysis analysis;
  const auto send = [&] {
    const ContactReport report = run.take_contact_reports().on_disk;
    analysis.add(run.state());
    analysis.add(report);
    lattice_impact::ParticleStates states = to_message(run.state());
    lattice_impact::ContactForces forces = to_message(report);
    states.run = forces.run = number;
    states.sequence = forces.sequence = sequence++;
    messages.emplace_back(states);
    messages.emplace_back(forces);
  };
  send();
  while (!run.finished()) {
    run.advance();
    send();
  }
  lattice_impact::RunStatus end =
      status_of(scene, number, sequence, lattice_impact::RunStatus::FINISHED);
  end.answer = numbers_to_message(analysis.restitution(true));
  end.answer_error = numbers_to_message({});
  end.restitution_of_run_error = Restitution::kNaN;
  messages.emplace_back(end);
  return messages;
}

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
  ImpactAnalysis analysis;
  analysis.add(run.state());
  while (!run.finished()) run.advance();
  analysis.add(run.state());
  return analysis.restitution(true).restitution;
}

TEST(SeriesAnalysis, OfMessagesEqualsTheDirectOne) {
  const Scene scene = small_scene(SceneKind::kCollision);
  Listener listener;
  listener.hear(messages_of(scene, 0));
  ASSERT_EQ(listener.results.size(), 2U);
  EXPECT_EQ(listener.results[0].ended, 0);
  EXPECT_EQ(listener.results[0].velocity_before, listener.results[1].velocity_before);
  EXPECT_TRUE(std::isnan(listener.results[0].restitution));
  EXPECT_EQ(listener.results[1].ended, 1);
  EXPECT_EQ(listener.results[1].complete, 1);
  EXPECT_EQ(listener.results[1].restitution, direct_restitution(scene));
  EXPECT_TRUE(listener.problems.empty());
}

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
