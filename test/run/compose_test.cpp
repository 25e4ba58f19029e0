#include "run/compose.hpp"

#include <gtest/gtest.h>

#include "expect_input_error.hpp"
#include "lattice/lammps_data.hpp"

namespace impact {
namespace {

using Names = std::vector<std::string>;

Scene contact_scene() {
  Scene scene;
  scene.kind = SceneKind::kContact;
  scene.material.eta = 100.0;
  return scene;
}

TEST(Compose, BuildsOnlyTheTermsOfTheScene) {
  Scene scene;
  EXPECT_EQ(compose(scene).field.terms(), (Names{"bonds (cubic)", "potential wall"}));
  scene.material.k_b = 0.0;
  EXPECT_EQ(compose(scene).field.terms(), (Names{"bonds", "potential wall"}));
  EXPECT_EQ(
      compose(contact_scene()).field.terms(),
      (Names{"bonds (cubic, damped)", "potential wall", "compression load", "rotation hold"}));
  Scene rolling = contact_scene();
  rolling.load.hold_rotation = false;
  EXPECT_EQ(compose(rolling).field.terms(),
            (Names{"bonds (cubic, damped)", "potential wall", "compression load"}));
}

TEST(Compose, StartsACollisionWhereTheWallIsNegligible) {
  const Scene scene;
  const Composition composition = compose(scene);
  EXPECT_NEAR(composition.field.wall->potential_energy(composition.initial.position) /
                  negligible_wall_energy(scene),
              1.0, 1e-9);
  EXPECT_TRUE((composition.initial.velocity.col(0) == 0.0).all());
  EXPECT_TRUE((composition.initial.velocity.col(1) == -0.01).all());
}

TEST(Compose, StartsAtAGivenGap) {
  Scene scene;
  scene.impact.gap = 0.25;
  EXPECT_NEAR(compose(scene).initial.position.col(1).minCoeff(), 0.25, 1e-15);
}

TEST(Compose, StartsAContactWhereOnePointCarriesTheLoad) {
  const Composition composition = compose(contact_scene());
  const double lowest = composition.initial.position.col(1).minCoeff();
  EXPECT_NEAR(composition.field.wall->force_at(lowest), 4.0e-3, 1e-12);
  EXPECT_TRUE((composition.initial.velocity == 0.0).all());
}

TEST(Compose, IsTheSameEveryTime) {
  const Composition first = compose(Scene{});
  const Composition second = compose(Scene{});
  EXPECT_TRUE((first.initial.position == second.initial.position).all());
  EXPECT_EQ(first.lattice.bonds, second.lattice.bonds);
  EXPECT_EQ(first.spectrum.omega_squared, second.spectrum.omega_squared);
  EXPECT_EQ(first.step, second.step);
}

TEST(Compose, TakesALatticeFromAFile) {
  const std::filesystem::path path = testing::TempDir() + "compose_test.data";
  const Composition original = compose(Scene{});
  write_lammps_data(original.lattice, 1.0 / 1099, path);
  Scene scene;
  scene.disk.file = path.string();
  scene.disk.recipe.points = 5;  // replaced by the file
  const Composition again = compose(scene);
  EXPECT_TRUE((again.initial.position == original.initial.position).all());
  EXPECT_EQ(again.step, original.step);
  scene.disk.file = "/nowhere/lattice.data";
  EXPECT_INPUT_ERROR(compose(scene), "/nowhere/lattice.data: cannot be read");
}

}  // namespace
}  // namespace impact
