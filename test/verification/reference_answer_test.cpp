#include "verification/reference_answer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/accuracy.hpp"

namespace impact {
namespace {

Scene small_impact() {
  Scene scene;
  scene.disk.recipe.points = 60;
  scene.impact.velocity = 0.03;
  scene.numerics.error = 1e-6;
  return scene;
}

void expect_kept(const Scene& scene) {
  const ReferenceAnswer reference = reference_answer(scene);
  EXPECT_EQ(reference.failure, "");
  EXPECT_LE(reference.error, 0.1 * scene.numerics.error);
  const AccuracyCheck check{scene, 0, reference, try_scene(scene)};
  EXPECT_EQ(check.trial.status, AccuracyTrial::kAnswered);
  EXPECT_EQ(verdict(check), Verdict::kKept);
}

TEST(ReferenceAnswer, AgreesWithSimpleImpacts) {
  Scene scene = small_impact();
  expect_kept(scene);
  scene.material.eta = 1.0;
  expect_kept(scene);
  scene.material.eta = 1000.0;  // stiff
  expect_kept(scene);
}

TEST(ReferenceAnswer, AgreesWithASimpleElasticWall) {
  Scene scene = small_impact();
  scene.wall.kind = WallKind::kLattice;
  scene.wall.points = 70;
  scene.numerics.error = 1e-4;
  expect_kept(scene);
}

TEST(ReferenceAnswer, AgreesWithSimpleContacts) {
  Scene scene;
  scene.kind = SceneKind::kContact;
  scene.disk.recipe.points = 100;
  scene.numerics.error = 1e-8;
  for (const double load : {1e-4, 4e-3}) {
    scene.load.p = load;
    expect_kept(scene);
  }
}

/// Disks that leave the wall spinning and strike it again, long after. Their restitution was found
/// by following them for ten times as long.
TEST(ReferenceAnswer, WaitsForTheSecondStrike) {
  Scene scene;
  scene.seed = 3;
  scene.disk.recipe.points = 3;
  scene.impact.velocity = 0.05;
  EXPECT_NEAR(reference_answer(scene).value, 0.9056, 1e-4);

  scene.seed = 443148;
  scene.disk.recipe = {15, Placement::kBlueNoise, false};
  scene.impact.velocity = 0.0384105;
  scene.wall.a = 622.791;
  EXPECT_NEAR(reference_answer(scene).value, 0.7541, 1e-4);
}

TEST(ReferenceAnswer, SaysWhyThereIsNone) {
  Scene scene;
  scene.disk.recipe.points = 2;
  const ReferenceAnswer reference = reference_answer(scene);
  EXPECT_TRUE(std::isinf(reference.error));
  EXPECT_NE(reference.failure, "");
}

}  // namespace
}  // namespace impact
