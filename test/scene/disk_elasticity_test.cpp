#include "scene/disk_elasticity.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace impact {
namespace {

TEST(DiskElasticity, AreThoseOfTheRecipe) {
  Scene scene;
  scene.material.k_a = 2.0;
  const DiskElasticity blue_noise = disk_elasticity(scene, {});
  EXPECT_DOUBLE_EQ(blue_noise.young_modulus.value, 2.164);
  EXPECT_EQ(blue_noise.poisson_ratio.value, 0.276);
  EXPECT_EQ(blue_noise.young_modulus.origin, "1.082 k_a, periodic bulk of blue noise placement");

  scene.disk.recipe.placement = Placement::kUniform;
  const DiskElasticity uniform = disk_elasticity(scene, {});
  EXPECT_DOUBLE_EQ(uniform.young_modulus.value, 2.084);
  EXPECT_EQ(uniform.poisson_ratio.value, 0.264);
}

TEST(DiskElasticity, OfAFileAreNotKnownUnlessGiven) {
  Scene scene;
  scene.disk.file = "mine.data";
  const DiskElasticity constants = disk_elasticity(scene, {1.2, std::nullopt});
  EXPECT_EQ(constants.young_modulus.value, 1.2);
  EXPECT_EQ(constants.young_modulus.origin, "parameter young_modulus");
  EXPECT_TRUE(std::isnan(constants.poisson_ratio.value));
}

}  // namespace
}  // namespace impact
