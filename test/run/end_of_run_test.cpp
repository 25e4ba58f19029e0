#include "run/end_of_run.hpp"

#include <gtest/gtest.h>

#include "mechanics/simulation.hpp"

namespace impact {
namespace {

Scene small_collision() {
  Scene scene;
  scene.disk.recipe.points = 60;
  scene.impact.velocity = 0.05;
  return scene;
}

Scene small_collision_with_a_lattice() {
  Scene scene = small_collision();
  scene.wall.kind = WallKind::kLattice;
  scene.wall.points = 70;
  return scene;
}

class SeparationEndOf : public testing::TestWithParam<Scene> {};

/// The end comes a waiting time after the last touch, with the disk going away.
TEST_P(SeparationEndOf, CollisionWaitsUntilTheDiskHasLeft) {
  const Scene& scene = GetParam();
  Composition composition = compose(scene);
  const auto end = end_of_run(scene, composition, composition.resolution.step);
  Simulation simulation(std::move(composition.field), std::move(composition.initial),
                        composition.rates.lattice, composition.resolution.step);
  const double negligible = negligible_wall_energy(scene);
  double last_touch = 0.0;
  while (!end->reached(simulation)) {
    simulation.step();
    if (simulation.field().wall_potential_energy(simulation.state().position) > negligible) {
      last_touch = simulation.state().time;
    }
    ASSERT_LT(simulation.state().time, 100.0);
  }
  EXPECT_GT(last_touch, 0.0);
  EXPECT_NEAR(simulation.state().time - last_touch, 5.0 / composition.rates.sound_speed,
              2.0 * simulation.step_size());
  EXPECT_GT(simulation.state().velocity.col(1).head(60).mean(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Walls, SeparationEndOf,
                         testing::Values(small_collision(), small_collision_with_a_lattice()));

TEST(RestEnd, IsReachedOnlyAtRest) {
  Scene scene;
  scene.kind = SceneKind::kContact;
  scene.disk.recipe.points = 60;
  scene.material.eta = 20.0;
  scene.load.p = 0.01;
  scene.numerics.integrator = IntegratorKind::kVerlet;
  Composition composition = compose(scene);
  const auto end = end_of_run(scene, composition, composition.resolution.step);
  Simulation simulation(std::move(composition.field), std::move(composition.initial),
                        composition.rates.lattice, composition.resolution.step);
  EXPECT_FALSE(end->reached(simulation));
  while (!end->reached(simulation)) {
    simulation.step();
    ASSERT_LT(simulation.state().time, 2000.0);
  }
  EXPECT_LE(simulation.largest_static_force(), 1e-5 * 0.01 / 60);
  EXPECT_LE(simulation.state().velocity.abs().maxCoeff(), 1e-5 * 0.01);
}

}  // namespace
}  // namespace impact
