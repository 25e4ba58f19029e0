#include "run/lammps_scene.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "expect_input_error.hpp"

namespace impact {
namespace {

Scene given_scene() {
  Scene scene;
  scene.disk.recipe.points = 50;
  scene.numerics.step = 0.01;
  return scene;
}

std::string script_of(const Scene& scene) {
  return lammps_script(scene, compose_for_lammps(scene_for_lammps(scene)));
}

void expect_line(const std::string& script, const std::string& line) {
  EXPECT_NE(script.find("\n" + line + "\n"), std::string::npos) << line << " is not in\n" << script;
}

TEST(LammpsScene, RefusesWhatLammpsCannotExpressByName) {
  const std::pair<std::function<void(Scene&)>, const char*> cases[] = {
      {[](Scene& s) { s.kind = SceneKind::kContact; }, "scene: got contact, allowed: collision"},
      {[](Scene& s) { s.kind = SceneKind::kStretch; }, "scene: got stretch, allowed: collision"},
      {[](Scene& s) { s.wall.kind = WallKind::kLattice; },
       "wall.type: got lattice, allowed: potential"},
      {[](Scene& s) { s.wall.kind = WallKind::kDisk; }, "wall.type: got disk, allowed: potential"},
      {[](Scene& s) { s.material.eta = 2.5; }, "material.eta: got 2.5, allowed: 0 in LAMMPS"},
      {[](Scene& s) { s.gravity = 1e-4; }, "gravity: got 0.0001, allowed: 0"},
      {[](Scene& s) { s.numerics.integrator = IntegratorKind::kRk8pd; },
       "numerics.integrator: got rk8pd, allowed: auto or verlet"}};
  for (const auto& [change, refusal] : cases) {
    Scene scene;
    change(scene);
    EXPECT_INPUT_ERROR(scene_for_lammps(scene), refusal);
  }
}

TEST(LammpsScene, MovesByVelocityVerlet) {
  const Scene scene = scene_for_lammps(Scene{});
  EXPECT_EQ(scene.numerics.integrator, IntegratorKind::kVerlet);
  const Composition composition = compose_for_lammps(scene);
  EXPECT_EQ(composition.resolution.integrator, IntegratorKind::kVerlet);
  expect_line(lammps_script(scene, composition),
              fmt::format("timestep {}", composition.resolution.step));
}

TEST(LammpsScene, RefusesAnUnstableStep) {
  Scene scene = given_scene();
  scene.numerics.step = 1.0;
  EXPECT_INPUT_ERROR(compose_for_lammps(scene_for_lammps(scene)), "numerics.step: got 1");
}

TEST(LammpsScene, IsNeverTooLong) {
  Scene scene = given_scene();
  scene.numerics.longest = 1e-6;
  EXPECT_EQ(compose_for_lammps(scene_for_lammps(scene)).initial.position.rows(), 50);
}

TEST(LammpsScene, HasTheWallOfTheScene) {
  Scene scene = given_scene();
  scene.wall.a = 200.0;
  scene.wall.v0 = 0.25;
  const std::string script = script_of(scene);
  expect_line(script, "variable push atom 50*exp(-200*y)");
  expect_line(script, "region near block INF INF INF 0.3 INF INF");
}

/// Each of 30° and 0.5: its sine and cosine.
TEST(LammpsScene, ThrowsTheDiskAsTheSceneSays) {
  Scene scene = given_scene();
  scene.impact.velocity = 0.5;
  scene.impact.spin = -0.125;
  const std::string straight = script_of(scene);
  expect_line(straight, "variable vx atom (0)-(-0.125)*(y-xcm(all,y))");
  expect_line(straight, "variable vy atom (-0.5)+(-0.125)*(x-xcm(all,x))");
  scene.impact.angle = 30.0;
  expect_line(script_of(scene), fmt::format("variable vx atom ({})-(-0.125)*(y-xcm(all,y))",
                                            scene.impact.tangential_velocity()));
}

TEST(LammpsScene, GoesOnAsLongAsARunWould) {
  Scene scene = given_scene();
  scene.impact.gap = 0.1;
  const Composition composition = compose_for_lammps(scene_for_lammps(scene));
  // 20 expected times, in steps of 0.01, rounded up to hundreds.
  const double least = 2000.0 * composition.expected_time;
  const std::string script = lammps_script(scene, composition);
  const std::size_t place = script.rfind("\nrun ");
  const int steps = std::stoi(script.substr(place + 5));
  EXPECT_EQ(steps % 100, 0);
  EXPECT_GE(steps, least);
  EXPECT_LT(steps, least + 100.0);
}

TEST(LammpsScene, TheDiskHasLeftWhenItIsBackAndTheWallIsDone) {
  Scene scene;
  scene.numerics.error = 4e-3;  // so that 10⁻⁶ of v²/2 = 2 may remain
  EXPECT_TRUE(has_left(scene, 0.0, 2.0, 1.9e-6));
  EXPECT_FALSE(has_left(scene, 0.0, 2.0, 2.1e-6));
  EXPECT_FALSE(has_left(scene, -1e-9, 2.0, 0.0));
  EXPECT_FALSE(has_left(scene, 1.0, -2.0, 0.0));
}

}  // namespace
}  // namespace impact
