#include "scene/scene_parameters.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "document.hpp"
#include "expect_input_error.hpp"
#include "scene/keys.hpp"

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

/// Those that are absent from a scene although others have them.
std::string missing_keys(const std::string& yaml) {
  const Scene scene = parse(yaml);
  std::string missing;
  for (const Parameter<Scene>& parameter : scene_parameters()) {
    if (!parameter.applies(scene)) missing += parameter.key + " ";
  }
  return missing;
}

TEST(ParseScene, HasTheKeysOfItsKind) {
  const std::string of_other_body = "wall.k_a wall.k_b wall.eta wall.threshold wall.file ";
  const std::string of_elastic_wall =
      "wall.points wall.width wall.height wall.gap_measure wall.boundary wall.reset_interval ";
  const std::string of_row = "wall.radius wall.mirrored wall.disks ";
  const std::string of_others = of_other_body + of_elastic_wall + of_row;
  const std::string of_contact = "load.P load.hold_rotation ";
  const std::string of_collision = "impact.velocity impact.angle impact.spin impact.gap gravity ";
  const std::string of_stretch = "stretch.width stretch.height stretch.strain ";
  const std::string of_motion =
      "disk.rim disk.file disk.scale disk.orientation material.eta wall.type wall.a wall.V0 ";
  EXPECT_EQ(missing_keys("{scene: collision}"), of_others + of_contact + of_stretch);
  EXPECT_EQ(missing_keys("{scene: collision, wall: {type: lattice}}"),
            of_row + of_contact + of_stretch);
  EXPECT_EQ(missing_keys("{scene: collision, wall: {type: disk}}"),
            of_elastic_wall + of_contact + "gravity " + of_stretch);
  EXPECT_EQ(missing_keys("{scene: contact, material: {eta: 1}}"),
            of_others + of_collision + of_stretch);
  EXPECT_EQ(missing_keys("{scene: stretch}"),
            of_motion + of_others + of_contact + of_collision +
                "numerics.step numerics.tolerance output.period ");
}

TEST(ParseScene, ReadsAnElasticWall) {
  const Scene::Wall wall =
      parse(
          "{scene: collision, wall: {type: lattice, points: 500, width: 3, height: auto, "
          "threshold: 0.1, gap_measure: vertical, boundary: viscous, reset_interval: 0.01, "
          "file: wall.data}}")
          .wall;
  EXPECT_EQ(wall.kind, WallKind::kLattice);
  EXPECT_EQ(wall.points, 500);
  EXPECT_EQ(wall.width, 3.0);
  EXPECT_FALSE(wall.height.has_value());
  EXPECT_EQ(wall.threshold, 0.1);
  EXPECT_EQ(wall.gap, GapMeasure::kVertical);
  EXPECT_EQ(wall.boundary, Boundary::kViscous);
  EXPECT_EQ(wall.reset_interval, 0.01);
  EXPECT_EQ(wall.file, "wall.data");
  EXPECT_EQ(parse("{scene: collision, wall: {boundary: fixed, type: lattice}}").wall.boundary,
            Boundary::kFixed);
}

/// Far below any step that a lattice needs there would be no step to count the interval in.
TEST(ParseScene, RefusesResetsWithoutEnd) {
  const auto parse_interval = [](const std::string& interval) {
    return parse("{scene: collision, wall: {type: lattice, reset_interval: " + interval + "}}");
  };
  EXPECT_INPUT_ERROR(parse_interval("1e-12"), "wall.reset_interval: got 1e-12, allowed: number in");
  EXPECT_EQ(parse_interval("1e-6").wall.reset_interval, 1e-6);
}

TEST(ParseScene, RefusesKeysOfAnElasticWallWithoutOne) {
  EXPECT_INPUT_ERROR(parse("{scene: collision, wall: {boundary: fixed}}"),
                     "wall.boundary: unknown key");
  EXPECT_INPUT_ERROR(parse("{scene: stretch, wall: {type: lattice}}"), "wall.type: unknown key");
  EXPECT_INPUT_ERROR(parse("{scene: stretch, output: {period: 0.1}}"),
                     "output.period: unknown key");
}

TEST(ParseScene, RefusesWhatDoesNotGoTogether) {
  EXPECT_INPUT_ERROR(parse("{seed: 1}"), "scene: got nothing, allowed: contact or collision");
  EXPECT_INPUT_ERROR(parse("{scene: contact, numerics: {integrator: verlet}}"),
                     "material.eta: got 0, allowed: above 0");
  EXPECT_NO_THROW(parse("{scene: contact}"));
  EXPECT_NO_THROW(parse("{scene: contact, numerics: {integrator: newton}}"));
  EXPECT_INPUT_ERROR(parse("{scene: collision, numerics: {integrator: newton}}"),
                     "numerics.integrator: got newton, allowed: a method of motion");
  for (const auto& [rest, cause] : std::map<std::string, std::string>{
           {"scene: contact", "a contact or stretch scene"},
           {"scene: collision, wall: {type: lattice}", "a wall that moves (wall.type)"},
           {"scene: collision, wall: {type: disk}", "a wall that moves (wall.type)"},
           {"scene: collision, material: {eta: 1}", "damping (material.eta above 0)"},
           {"scene: collision, gravity: 0.1", "gravity"},
           {"scene: collision, impact: {spin: 0.1}", "a disk that spins at the start"}}) {
    EXPECT_INPUT_ERROR(parse("{numerics: {integrator: reduced}, " + rest + "}"),
                       "numerics.integrator: got reduced, allowed: another one with " + cause);
  }
  EXPECT_NO_THROW(
      parse("{scene: collision, impact: {angle: 10}, numerics: {integrator: reduced, step: 1}}"));
  for (const auto& [rest, cause] : std::map<std::string, std::string>{
           {"scene: contact, material: {eta: 1}", "a contact or stretch scene"},
           {"scene: collision, wall: {type: lattice}", "a wall that moves (wall.type)"},
           {"scene: collision, gravity: 0.1", "gravity"},
           {"scene: collision, impact: {spin: 0.1}", "a disk that spins at the start"},
           {"scene: collision, impact: {angle: 10}", "an oblique impact (impact.angle)"}}) {
    EXPECT_INPUT_ERROR(parse("{numerics: {integrator: modal}, " + rest + "}"),
                       "numerics.integrator: got modal, allowed: another one with " + cause);
  }
  EXPECT_NO_THROW(
      parse("{scene: collision, material: {eta: 1}, numerics: {integrator: modal, step: 1}}"));
  EXPECT_INPUT_ERROR(parse("{scene: stretch, numerics: {integrator: verlet}}"),
                     "numerics.integrator: got verlet, allowed: auto or newton in a stretch scene");
  EXPECT_INPUT_ERROR(parse("{scene: stretch, stretch: {strain: 0}}"),
                     "stretch.strain: got 0, allowed: at most -1e-06 or at least 1e-06");
  EXPECT_INPUT_ERROR(parse("{scene: stretch, stretch: {strain: -1e-300}}"),
                     "stretch.strain: got -1e-300, allowed: at most -1e-06");
  EXPECT_NO_THROW(parse("{scene: stretch, stretch: {strain: -1e-6}}"));
  EXPECT_INPUT_ERROR(parse("{scene: contact, material: {eta: 1}, wall: {type: lattice}}"),
                     "wall.type: got lattice, allowed: potential in a contact scene");
}

/// A method for forces that do not depend on velocities has no scene in which they do.
TEST(ParseScene, RefusesBlanesMoanWithDamping) {
  const std::string refused =
      "numerics.integrator: got blanes_moan, allowed: another one where forces depend on "
      "velocities";
  const auto parse_with = [](const std::string& rest) {
    return parse("{scene: collision, numerics: {integrator: blanes_moan}, " + rest + "}");
  };
  EXPECT_NO_THROW(parse_with("material: {eta: 0}"));
  EXPECT_INPUT_ERROR(parse_with("material: {eta: 1}"), refused);
  EXPECT_NO_THROW(parse_with("wall: {type: lattice}"));
  EXPECT_INPUT_ERROR(parse_with("wall: {type: lattice, boundary: viscous}"), refused);
}

/// Nor has one for contacts that stay on their points.
TEST(ParseScene, RefusesTakahashiImadaWhereContactsPassOn) {
  const auto parse_with = [](const std::string& rest) {
    return parse("{scene: collision, numerics: {integrator: takahashi_imada}, " + rest + "}");
  };
  EXPECT_NO_THROW(parse_with("wall: {type: potential}"));
  for (const char* const type : {"lattice", "disk"}) {
    EXPECT_INPUT_ERROR(parse_with(std::string("wall: {type: ") + type + "}"),
                       "numerics.integrator: got takahashi_imada, allowed: another one where "
                       "contacts pass from bond to bond (wall.type other than potential)");
  }
  EXPECT_INPUT_ERROR(parse_with("material: {eta: 1}"),
                     "numerics.integrator: got takahashi_imada, allowed: another one where forces "
                     "depend on velocities");
}

TEST(ParseScene, HasAStepOrAToleranceByTheIntegrator) {
  const auto parse_with = [](const std::string& numerics) {
    return parse("{scene: contact, material: {eta: 1}, numerics: {" + numerics + "}}");
  };
  EXPECT_NO_THROW(parse_with("integrator: verlet, step: 0.01"));
  EXPECT_NO_THROW(parse_with("integrator: bdf, tolerance: 0.01"));
  EXPECT_INPUT_ERROR(parse_with("integrator: bdf, step: 0.01"),
                     "numerics.step: got 0.01, allowed: auto with an integrator that chooses");
  EXPECT_INPUT_ERROR(parse_with("integrator: newton, step: 0.01"),
                     "numerics.step: got 0.01, allowed: auto with a static solution");
  EXPECT_INPUT_ERROR(parse_with("integrator: verlet, tolerance: 0.01"),
                     "numerics.tolerance: got 0.01, allowed: auto unless");
}

/// Unless a step asks for motion.
TEST(ParseScene, SolvesAContactWithoutMotionByItself) {
  EXPECT_TRUE(parse("{scene: contact}").is_static());
  EXPECT_FALSE(parse("{scene: contact, material: {eta: 1}, numerics: {step: 0.01}}").is_static());
  EXPECT_FALSE(parse("{scene: collision}").is_static());
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

TEST(ParseSeries, RefusesAValueTwice) {
  EXPECT_INPUT_ERROR(parse_series(keys("{scene: collision, seed: [1, 2, 1]}")),
                     "seed: got [1, 2, 1], allowed: no value twice");
  EXPECT_INPUT_ERROR(parse_series(keys("{scene: collision, impact: {velocity: [0.01, 1e-2]}}")),
                     "impact.velocity: got [0.01, 1e-2], allowed: no value twice");
}

TEST(ParseSeries, RefusesMoreScenesThanItCanHold) {
  std::string list;
  for (int i = 1; i <= 400; ++i) list += fmt::format("{}{}", i == 1 ? "" : ", ", i);
  EXPECT_INPUT_ERROR(
      parse_series(keys("{scene: collision, seed: [" + list + "], wall: {a: [" + list + "]}}")),
      "wall.a: more than 100000 combinations");
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

TEST(ToYaml, ReadsBackAnElasticWallAndAStretch) {
  Scene wall = parse("{scene: collision, wall: {type: lattice, width: 3, boundary: fixed}}");
  wall.wall.threshold = 1.0 / 3.0;
  const Scene again = parse(to_yaml(wall));
  EXPECT_EQ(to_yaml(again), to_yaml(wall));
  EXPECT_EQ(again.wall.threshold, wall.wall.threshold);
  EXPECT_EQ(again.wall.boundary, Boundary::kFixed);
  Scene stretch = parse("{scene: stretch, stretch: {strain: -0.001}}");
  stretch.stretch.width = 10.0 / 3.0;
  EXPECT_EQ(parse(to_yaml(stretch)).stretch.width, stretch.stretch.width);
  EXPECT_EQ(to_yaml(stretch).find("wall"), std::string::npos);
}

TEST(ParseScene, RefusesSpeedsThatRoundingWouldSwallow) {
  EXPECT_INPUT_ERROR(parse("{scene: collision, impact: {velocity: 1.0e-300}}"),
                     "impact.velocity: got 1.0e-300, allowed: number in [1e-09, 1]");
}

class SceneFiles : public testing::TestWithParam<const char*> {};

/// The scene files show every key that their scene has, except for files that replace a recipe.
TEST_P(SceneFiles, AreCompleteAndValid) {
  const FlatTree tree = load_keys(std::string(SOURCE_DIR "/launch/scenes/") + GetParam());
  const Scene scene = parse_scene(tree);
  for (const Parameter<Scene>& parameter : scene_parameters()) {
    const bool replaces = parameter.key == "disk.file" || parameter.key == "disk.scale" ||
                          parameter.key == "wall.file";
    if (!parameter.applies(scene) || replaces) continue;
    EXPECT_EQ(tree.count(parameter.key), 1U) << parameter.key;
  }
}

INSTANTIATE_TEST_SUITE_P(Launch, SceneFiles,
                         testing::Values("collision.yaml", "contact.yaml", "absorbing_wall.yaml",
                                         "oblique.yaml", "disk_on_disk.yaml", "row_of_disks.yaml",
                                         "stretch.yaml"));

/// The page's table is the one from which the keys are validated.
TEST(Documents, HaveTheSceneKeys) {
  expect_document_has("parameters.md", "scene keys", markdown_table(scene_parameters(), Scene{}));
}

TEST(SceneParameters, ASingleSceneHasNoLists) {
  EXPECT_EQ(parse_single_scene(flatten(YAML::Load("{scene: collision, seed: 3}"))).seed, 3U);
  EXPECT_INPUT_ERROR(parse_single_scene(flatten(YAML::Load("{scene: collision, seed: [1, 2]}"))),
                     "seed: got [1, 2], allowed: one value");
}

}  // namespace
}  // namespace impact
