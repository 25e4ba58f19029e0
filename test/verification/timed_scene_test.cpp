#include "verification/timed_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace impact {
namespace {

Scene small_collision() {
  Scene scene;
  scene.disk.recipe.points = 60;
  scene.impact.velocity = 0.05;
  scene.output.period = 1e6;
  return scene;
}

TEST(CanHave, KnowsTheIntegratorsOfAScene) {
  Scene scene = small_collision();
  EXPECT_TRUE(can_have(scene, IntegratorKind::kBlanesMoan));
  EXPECT_FALSE(can_have(scene, IntegratorKind::kNewton));
  scene.material.eta = 1.0;
  EXPECT_FALSE(can_have(scene, IntegratorKind::kBlanesMoan));
  EXPECT_TRUE(can_have(scene, IntegratorKind::kExtrapolatedDamping));
  scene.kind = SceneKind::kContact;
  EXPECT_TRUE(can_have(scene, IntegratorKind::kNewton));
}

TEST(MostExact, IsOfOrder6) {
  Scene scene;
  EXPECT_EQ(most_exact(scene), IntegratorKind::kBlanesMoan);
  scene.material.eta = 1.0;
  EXPECT_EQ(most_exact(scene), IntegratorKind::kExtrapolatedDamping);
}

TEST(LongestStep, IsAllowed) {
  Scene scene = small_collision();
  for (const IntegratorKind integrator : {IntegratorKind::kVerlet, IntegratorKind::kBlanesMoan}) {
    scene.numerics.integrator = integrator;
    scene.numerics.step = longest_step(scene, integrator);
    EXPECT_NO_THROW(compose(scene));
    *scene.numerics.step *= 2.0;
    EXPECT_THROW(compose(scene), std::runtime_error);
  }
}

TEST(TimedScene, UpToATimeOrToTheAnswerGivesTheSameAnswer) {
  Scene scene = small_collision();
  scene.numerics.integrator = IntegratorKind::kVerlet;
  scene.numerics.step = 0.005;
  TimedScene to_answer(scene, Until::kAnswer);
  to_answer.run(100.0);
  scene.output.period = 5.5;
  TimedScene to_time(scene, Until::kTime);
  to_time.run(100.0);
  ASSERT_TRUE(to_answer.has_answer());
  ASSERT_TRUE(to_time.has_answer());
  // At that time the disk has left the wall, whose energy is negligible: error/100 of the impact's.
  EXPECT_NEAR(to_time.outcome().answer, to_answer.outcome().answer, 0.01 * scene.numerics.error);
  EXPECT_EQ(to_time.outcome().step, 0.005);
  // Velocity Verlet evaluates once at the start and once a step.
  EXPECT_EQ(to_time.outcome().evaluations, 1101.0);
}

TEST(TimedScene, IsGivenUpAfterAWhile) {
  TimedScene one(small_collision(), Until::kAnswer);
  one.run(0.0);
  EXPECT_FALSE(one.has_answer());
  EXPECT_EQ(one.outcome().flags, "takes too long");
}

TEST(TimedScene, TakesAFailureDown) {
  Scene scene = small_collision();
  scene.numerics.step = 10.0;
  TimedScene one(scene, Until::kAnswer);
  one.run(100.0);
  EXPECT_FALSE(one.has_answer());
  EXPECT_NE(one.outcome().flags.find("numerics.step"), std::string::npos);
}

TEST(RepeatInTurn, LeavesOutWhatHasNoAnswerOrTookLong) {
  Effort effort;
  effort.rounds = 3;
  std::vector<TimedScene> list{{small_collision(), Until::kAnswer},
                               {small_collision(), Until::kAnswer}};
  list[0].run(0.0);
  list[1].run(100.0);
  repeat_in_turn(list, effort);
  EXPECT_EQ(list[0].runs(), 1U);
  EXPECT_EQ(list[1].runs(), 3U);
  effort.most = 0.0;
  repeat_in_turn(list, effort);
  EXPECT_EQ(list[1].runs(), 3U);
}

TEST(Effort, AsksForPowersOfTen) {
  Effort effort;
  effort.last_power = 4;
  const std::vector<double> errors = effort.errors();
  ASSERT_EQ(errors.size(), 3U);
  EXPECT_DOUBLE_EQ(errors.front(), 1e-2);
  EXPECT_DOUBLE_EQ(errors.back(), 1e-4);
}

}  // namespace
}  // namespace impact
