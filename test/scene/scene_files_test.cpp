#include "scene/scene_files.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "expect_input_error.hpp"

namespace impact {
namespace {

const std::filesystem::path kScenes = SOURCE_DIR "/launch/scenes";

TEST(ScenePath, FindsASceneByName) {
  EXPECT_EQ(scene_path("collision", kScenes), kScenes / "collision.yaml");
}

TEST(ScenePath, LeavesAPathAlone) {
  EXPECT_EQ(scene_path("collision.yaml", kScenes), "collision.yaml");
  EXPECT_EQ(scene_path("./collision", kScenes), "./collision");
}

TEST(ScenePath, PrefersAFileOfThatName) {
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(testing::TempDir());
  std::ofstream("contact") << "scene: contact\n";
  EXPECT_EQ(scene_path("contact", kScenes), "contact");
  std::filesystem::remove("contact");
  EXPECT_EQ(scene_path("contact", kScenes), kScenes / "contact.yaml");
  std::filesystem::current_path(here);
}

TEST(ScenePath, SaysWhichScenesThereAre) {
  EXPECT_INPUT_ERROR(
      scene_path("colision", kScenes),
      "colision: no such scene (did you mean collision?), allowed: a scene file, "
      "absorbing_wall, collision, contact, disk_on_disk, oblique, row_of_disks, stretch");
  EXPECT_INPUT_ERROR(scene_path("x", "/nowhere"), "x: no such scene, allowed: a scene file");
}

/// Of a program in PREFIX/lib/PACKAGE.
TEST(SceneFolder, LiesBesideTheProgram) {
  const std::filesystem::path folder = scene_folder();
  EXPECT_EQ(folder.filename(), "scenes");
  const auto programs = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  EXPECT_EQ(folder.parent_path().parent_path(),
            programs.parent_path().parent_path() / "share" / programs.filename());
}

}  // namespace
}  // namespace impact
