#include "scene/scene_parameters.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "expect_input_error.hpp"

namespace impact {
namespace {

FlatTree keys(const std::string& yaml) { return flatten(YAML::Load(yaml)); }
Scene parse(const std::string& yaml) { return parse_scene(keys(yaml)); }

TEST(ParseScene, TakesDefaultsForWhatIsAbsent) {
  const Scene scene = parse("{scene: collision, impact: {velocity: 0.02}}");
  EXPECT_EQ(scene.kind, SceneKind::kCollision);
  EXPECT_EQ(scene.impact.velocity, 0.02);
  EXPECT_EQ(scene.disk.recipe.points, 1099);
  EXPECT_FALSE(scene.impact.gap.has_value());
}

TEST(ParseScene, RefusesKeysOfOtherScenes) {
  EXPECT_INPUT_ERROR(parse("{scene: collision, load: {P: 0.01}}"), "load.P: unknown key");
  EXPECT_INPUT_ERROR(parse("{scene: contact, material: {eta: 1}, impact: {velocity: 0.01}}"),
                     "impact.velocity: unknown key");
}

TEST(ParseScene, RefusesWhatDoesNotGoTogether) {
  EXPECT_INPUT_ERROR(parse("{seed: 1}"), "scene: got nothing, allowed: contact or collision");
  EXPECT_INPUT_ERROR(parse("{scene: contact}"), "material.eta: got 0, allowed: above 0");
  EXPECT_NO_THROW(parse("{scene: contact, numerics: {integrator: newton}}"));
  EXPECT_INPUT_ERROR(parse("{scene: collision, numerics: {integrator: newton}}"),
                     "numerics.integrator: got newton, allowed: auto or verlet");
}

TEST(ParseSeries, TakesEveryCombination) {
  const std::vector<Scene> series =
      parse_series(keys("{scene: collision, impact: {velocity: [0.01, 0.02]}, seed: [1, 2, 3]}"));
  ASSERT_EQ(series.size(), 6U);
  EXPECT_EQ(series[1].impact.velocity, 0.01);
  EXPECT_EQ(series[1].seed, 2U);
  EXPECT_EQ(series[3].impact.velocity, 0.02);
  EXPECT_EQ(series[3].seed, 1U);
}

TEST(ParseSeries, ChecksEveryRun) {
  EXPECT_INPUT_ERROR(parse_series(keys("{scene: collision, impact: {velocity: [0.01, 2]}}")),
                     "impact.velocity: got 2, allowed");
  EXPECT_INPUT_ERROR(parse_series(keys("{scene: collision, seed: []}")),
                     "seed: got [], allowed: one value at least");
}

TEST(ToYaml, ReadsBackToTheSameScene) {
  Scene scene = parse("{scene: contact, material: {eta: 100, k_b: 0.1}, load: {P: 0.0123456789}}");
  scene.wall.a = 1.0 / 3.0 + 299.0;
  const Scene again = parse(to_yaml(scene));
  EXPECT_EQ(to_yaml(again), to_yaml(scene));
  EXPECT_EQ(again.wall.a, scene.wall.a);
  EXPECT_EQ(again.load.p, scene.load.p);
  EXPECT_EQ(to_yaml(scene).find("impact"), std::string::npos);
}

TEST(OverrideKey, ReplacesOneKey) {
  FlatTree tree = keys("{scene: collision, impact: {velocity: 0.01}}");
  override_key(tree, "impact.velocity=0.05");
  override_key(tree, "seed=7");
  EXPECT_EQ(parse_scene(tree).impact.velocity, 0.05);
  EXPECT_EQ(parse_scene(tree).seed, 7U);
  EXPECT_INPUT_ERROR(override_key(tree, "seed"), "seed: allowed: key=value");
  EXPECT_INPUT_ERROR(override_key(tree, "seed=[1"), "seed: ");
}

TEST(LoadKeys, SaysWhyAFileCannotBeUsed) {
  EXPECT_INPUT_ERROR(load_keys("/nowhere/scene.yaml"), "cannot be read");
  const std::string path = testing::TempDir() + "broken_scene.yaml";
  std::ofstream(path) << "scene: collision\nimpact: {velocity: 0.01\n";
  EXPECT_INPUT_ERROR(load_keys(path), "broken_scene.yaml:3: ");
}

class SceneFiles : public testing::TestWithParam<const char*> {};

/// The scene files show every key that their scene has.
TEST_P(SceneFiles, AreCompleteAndValid) {
  const FlatTree tree = load_keys(std::string(SOURCE_DIR "/launch/scenes/") + GetParam());
  const Scene scene = parse_scene(tree);
  for (const Parameter<Scene>& parameter : scene_parameters()) {
    if (!parameter.applies(scene) || parameter.key == "disk.file") continue;
    EXPECT_EQ(tree.count(parameter.key), 1U) << parameter.key;
  }
}

INSTANTIATE_TEST_SUITE_P(Launch, SceneFiles, testing::Values("collision.yaml", "contact.yaml"));

/// The README's table is the one from which the keys are validated.
TEST(Readme, HasTheTableOfSceneKeys) {
  std::ifstream file(SOURCE_DIR "/README.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  const std::string table = markdown_table(scene_parameters(), Scene{});
  EXPECT_NE(readme.find(table), std::string::npos) << "README.md should hold\n" << table;
}

}  // namespace
}  // namespace impact
