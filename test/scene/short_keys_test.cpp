#include "scene/short_keys.hpp"

#include <gtest/gtest.h>

#include "expect_input_error.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

FlatTree keys_of(const std::string& yaml) { return flatten(YAML::Load(yaml)); }

Scene scene_with(const std::string& yaml, const std::vector<std::string>& assignments) {
  FlatTree tree = keys_of(yaml);
  override_keys(tree, assignments);
  return parse_scene(tree);
}

TEST(ParseAssignment, TakesTheFirstEqualsSign) {
  EXPECT_EQ(parse_assignment("disk.file=a=b"), Assignment("disk.file", "a=b"));
  EXPECT_INPUT_ERROR(parse_assignment("seed"), "seed: allowed: key=value");
  EXPECT_INPUT_ERROR(parse_assignment("=1", "key=values"), "=1: allowed: key=values");
}

TEST(OverrideKeys, TakesFullAndShortKeys) {
  const Scene scene = scene_with("{scene: collision, impact: {velocity: 0.01}}",
                                 {"impact.velocity=0.05", "seed=7", "points=50", "file=a.data"});
  EXPECT_EQ(scene.impact.velocity, 0.05);
  EXPECT_EQ(scene.seed, 7U);
  EXPECT_EQ(scene.disk.recipe.points, 50);  // the potential wall has none
  EXPECT_EQ(scene.disk.file, "a.data");
  EXPECT_EQ(scene_with("{scene: collision}", {"velocity=0.02", "velocity=0.03"}).impact.velocity,
            0.03);
}

TEST(OverrideKeys, RefusesAnAmbiguousKeyAndNamesBoth) {
  EXPECT_INPUT_ERROR(scene_with("{scene: collision, wall: {type: lattice}}", {"points=50"}),
                     "points: ambiguous, allowed: disk.points or wall.points");
  EXPECT_INPUT_ERROR(scene_with("{scene: collision}", {"points=50", "wall.type=lattice"}),
                     "points: ambiguous, allowed: disk.points or wall.points");
}

/// Whatever material the wall may have of its own.
TEST(OverrideKeys, MeansTheMaterialByItsShortKeys) {
  const Scene scene =
      scene_with("{scene: collision, wall: {type: lattice}}", {"eta=2", "k_a=3", "wall.k_b=0.5"});
  EXPECT_EQ(scene.material.eta, 2.0);
  EXPECT_EQ(scene.material.k_a, 3.0);
  EXPECT_FALSE(scene.wall.k_a || scene.wall.eta);
  EXPECT_EQ(scene.wall.k_b, 0.5);
}

TEST(OverrideKeys, KnowsTheKeysOfTheKindThatIsAskedFor) {
  const Scene wall = scene_with("{scene: collision}", {"boundary=fixed", "type=lattice"});
  EXPECT_EQ(wall.wall.boundary, Boundary::kFixed);
  EXPECT_EQ(scene_with("{scene: collision}", {"P=0.005", "scene=contact"}).load.p, 0.005);
  EXPECT_INPUT_ERROR(scene_with("{scene: collision}", {"P=0.005"}), "P: unknown key");
}

TEST(WithFullKeys, TakesLists) {
  const auto full = with_full_keys(keys_of("{scene: collision}"),
                                   {{"type", "potential,lattice"}, {"boundary", "fixed,viscous"}});
  EXPECT_EQ(full[0].first, "wall.type");
  EXPECT_EQ(full[1].first, "wall.boundary");
  EXPECT_EQ(full[1].second, "fixed,viscous");
  EXPECT_EQ(with_full_keys(keys_of("{scene: collision, wall: {type: [potential, lattice]}}"),
                           {{"boundary", "fixed"}})[0]
                .first,
            "wall.boundary");
}

TEST(KeysOfScene, AreThoseOfTheFileAndTheAssignments) {
  const std::string file = std::string(SOURCE_DIR) + "/launch/scenes/collision.yaml";
  EXPECT_EQ(parse_scene(keys_of_scene(file, {"velocity=0.05"})).impact.velocity, 0.05);
  EXPECT_INPUT_ERROR(keys_of_scene("/nowhere.yaml", {}), "/nowhere.yaml");
}

}  // namespace
}  // namespace impact
