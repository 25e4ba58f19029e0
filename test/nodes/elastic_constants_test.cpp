#include "nodes/elastic_constants.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace impact {
namespace {

TEST(ElasticConstants, AreThoseOfTheRecipe) {
  Scene scene;
  scene.material.k_a = 2.0;
  const ElasticConstants blue_noise = elastic_constants(scene, {});
  EXPECT_DOUBLE_EQ(blue_noise.young_modulus.value, 2.17);
  EXPECT_EQ(blue_noise.poisson_ratio.value, 0.275);
  EXPECT_EQ(blue_noise.young_modulus.origin, "1.085 k_a, periodic bulk of blue noise placement");

  scene.disk.recipe.placement = Placement::kUniform;
  const ElasticConstants uniform = elastic_constants(scene, {});
  EXPECT_DOUBLE_EQ(uniform.young_modulus.value, 2.08);
  EXPECT_EQ(uniform.poisson_ratio.value, 0.265);
}

TEST(ElasticConstants, OfAFileAreNotKnownUnlessGiven) {
  Scene scene;
  scene.disk.file = "mine.data";
  const ElasticConstants constants = elastic_constants(scene, {1.2, std::nullopt});
  EXPECT_EQ(constants.young_modulus.value, 1.2);
  EXPECT_EQ(constants.young_modulus.origin, "parameter young_modulus");
  EXPECT_TRUE(std::isnan(constants.poisson_ratio.value));
}

}  // namespace
}  // namespace impact
