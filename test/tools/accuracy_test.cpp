#include "tools/accuracy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/scene_parameters.hpp"
#include "tools/reference_integrator.hpp"

namespace impact {
namespace {

constexpr std::uint64_t kSeed = 1;

TEST(RandomScene, FollowsFromSeedAndNumber) {
  EXPECT_EQ(to_yaml(random_scene(kSeed, 3)), to_yaml(random_scene(kSeed, 3)));
  EXPECT_NE(to_yaml(random_scene(kSeed, 3)), to_yaml(random_scene(kSeed, 8)));
  EXPECT_NE(to_yaml(random_scene(kSeed, 3)), to_yaml(random_scene(kSeed + 1, 3)));
}

/// Of five, one contact and one elastic wall; half of the others and of all k_b are without.
TEST(RandomScene, HasTheDocumentedShares) {
  constexpr int kScenes = 1000;
  int contacts = 0;
  int elastic_walls = 0;
  int damped = 0;
  int cubic = 0;
  for (int number = 0; number < kScenes; ++number) {
    const Scene scene = random_scene(kSeed, number);
    const bool elastic = scene.wall.kind == WallKind::kLattice;
    contacts += scene.kind == SceneKind::kContact ? 1 : 0;
    elastic_walls += elastic ? 1 : 0;
    damped += scene.material.eta > 0.0 ? 1 : 0;
    cubic += scene.material.k_b > 0.0 ? 1 : 0;
    EXPECT_FALSE(elastic && scene.material.eta > 0.0);
  }
  EXPECT_EQ(contacts, kScenes / 5);
  EXPECT_EQ(elastic_walls, kScenes / 5);
  // Four standard deviations of a coin's sum.
  EXPECT_NEAR(damped, 300, 4.0 * std::sqrt(600 * 0.25));
  EXPECT_NEAR(cubic, 500, 4.0 * std::sqrt(1000 * 0.25));
}

class Accuracy : public testing::TestWithParam<int> {};  // over scenes

/// The reference is good to a hundredth of the errors that are asked, and what is promised is kept.
TEST_P(Accuracy, IsAsPromised) {
  offer_reference_integrator();
  const Scene scene = random_scene(kSeed, GetParam());
  const ReferenceAnswer reference = reference_answer(scene);
  EXPECT_EQ(reference.failure, "");
  for (const double error : asked_errors(scene)) {
    const AccuracyTrial trial = try_accuracy(scene, error, reference);
    EXPECT_EQ(trial.status, "answered");
    EXPECT_LT(reference.error, 0.01 * error);
    EXPECT_LE(trial.estimated_error, error);
    EXPECT_LE(trial.true_error, error);
  }
}

/// Quick ones: a contact, an elastic wall, damped and undamped impacts on the potential wall.
INSTANTIATE_TEST_SUITE_P(Scenes, Accuracy, testing::Values(2, 3, 4, 5, 6, 8));

}  // namespace
}  // namespace impact
