#include "run/forecast.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "expect_input_error.hpp"
#include "lattice/lammps_writing.hpp"
#include "run/compose.hpp"
#include "run/run.hpp"

namespace impact {
namespace {

Scene default_absorbing_wall() {
  Scene scene;
  scene.wall.kind = WallKind::kLattice;
  return scene;
}

Scene contact(IntegratorKind integrator) {
  Scene scene;
  scene.kind = SceneKind::kContact;
  scene.material.eta = 100.0;
  scene.numerics.integrator = integrator;
  return scene;
}

Scene slow_and_far() {
  Scene scene;
  scene.impact.gap = 100.0;
  scene.impact.velocity = 1e-9;
  scene.numerics.integrator = IntegratorKind::kVerlet;
  return scene;
}

/// There and back again, 2·10¹¹ R/c in steps of 0.01 … 0.1 R/c, about three times.
TEST(Forecast, CountsTheStepsOfTheWay) {
  const double steps = forecast(slow_and_far()).steps;
  EXPECT_GT(steps, 6e12);
  EXPECT_LT(steps, 6e13);
}

/// The steps of the first run are those that it takes, within a factor of 2: there is one number
/// for all lattices.
TEST(Forecast, IsWhatARunTakes) {
  Scene slow;
  slow.impact.velocity = 0.003;
  Scene damped;
  damped.material.eta = 100.0;
  Scene given;
  given.numerics.step = 0.001;
  Scene large;
  large.disk.recipe.points = 10000;
  for (const Scene& scene : {Scene{}, slow, damped, given, large, default_absorbing_wall()}) {
    impact::Run run(scene);
    while (!run.finished()) run.advance();
    const double runs = scene.numerics.step ? 1.0 : 3.0;
    const double ratio = forecast(scene).steps / (runs * static_cast<double>(run.state().step));
    EXPECT_GT(ratio, 0.5);
    EXPECT_LT(ratio, 2.0);
  }
}

TEST(Forecast, GrowsWithPointsAndWithShorterSteps) {
  const double small = forecast(Scene{}).seconds;
  Scene large;
  large.disk.recipe.points = 1000000;
  EXPECT_GT(forecast(large).seconds, 1e4 * small);  // N^(3/2) at least
  EXPECT_GT(forecast(default_absorbing_wall()).seconds, 2.0 * small);
  Scene reset = default_absorbing_wall();
  reset.wall.reset_interval = 1e-6;
  EXPECT_GT(forecast(reset).seconds, 1000.0 * forecast(default_absorbing_wall()).seconds);
}

TEST(Forecast, KnowsThatLightContactsRelaxForLong) {
  for (const auto integrator :
       {IntegratorKind::kBdf, IntegratorKind::kVerlet, IntegratorKind::kImplicitDamping}) {
    Scene scene = contact(integrator);
    EXPECT_LT(forecast(scene).seconds, 60.0);
    scene.load.p = 1e-6;
    EXPECT_GT(forecast(scene).seconds, 3600.0);
  }
  Scene scene = contact(IntegratorKind::kAuto);
  scene.load.p = 1e-6;
  EXPECT_LT(forecast(scene).seconds, 1.0);
}

TEST(Forecast, ReadsLikeThis) {
  EXPECT_EQ(text({2.13e8, 720.0}), "2.1e+08 steps and 12 min on one processor");
  EXPECT_EQ(text({1e4, 110.0}), "1e+04 steps and 1.8 min on one processor");
  EXPECT_EQ(text({15.0, 0.25}), "15 steps and 0.25 s on one processor");
  EXPECT_EQ(text({2.1e13, 1e9}), "2.1e+13 steps and 2.8e+05 h on one processor");
}

TEST(RefuseIfTooLong, NamesTheKeysThatAreToBlame) {
  EXPECT_INPUT_ERROR(refuse_if_too_long(slow_and_far()),
                     "numerics.longest: this scene would take about ");
  EXPECT_INPUT_ERROR(refuse_if_too_long(slow_and_far()),
                     " h on one processor (numerics.integrator, impact.velocity, impact.gap), "
                     "allowed: at most 3600 s");
  Scene light = contact(IntegratorKind::kBdf);
  light.load.p = 1e-6;
  EXPECT_INPUT_ERROR(refuse_if_too_long(light), "(numerics.integrator, load.P)");
  Scene many;
  many.numerics.longest = 60.0;
  many.disk.recipe.points = 1000000;
  EXPECT_INPUT_ERROR(refuse_if_too_long(many), "(disk.points), allowed: at most 60 s");
  Scene reset = default_absorbing_wall();
  reset.wall.reset_interval = 1e-6;
  reset.numerics.longest = 60.0;
  EXPECT_INPUT_ERROR(refuse_if_too_long(reset), "(wall.reset_interval)");
}

TEST(RefuseIfTooLong, LeavesTheLimitToTheScene) {
  Scene scene;
  EXPECT_NO_THROW(refuse_if_too_long(scene));
  scene.numerics.longest = 1e-3;
  EXPECT_INPUT_ERROR(refuse_if_too_long(scene), "allowed: at most 0.001 s");
  EXPECT_INPUT_ERROR(compose(scene), "numerics.longest: ");
}

/// Of the default scene no key is to blame.
TEST(RefuseIfTooLong, BlamesNoDefault) {
  Scene scene;
  scene.numerics.longest = 1e-3;
  EXPECT_INPUT_ERROR(refuse_if_too_long(scene), "on one processor, allowed");
}

/// A million points would take seconds to place.
TEST(RefuseIfTooLong, NeedsNoLattice) {
  Scene scene = slow_and_far();
  scene.disk.recipe.points = 1000000;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_INPUT_ERROR(compose(scene), "numerics.longest: ");
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  EXPECT_LT(time.count(), 0.5);
}

/// The recipe of a scene with a file says nothing.
TEST(RefuseIfTooLong, CountsThePointsOfAFile) {
  const std::string path = testing::TempDir() + "forecast_disk.data";
  Scene scene;
  scene.disk.recipe.points = 30000;
  write_lammps_data(triangulated_lattice(place_in_disk(scene.disk.recipe, 1)), 1.0, path);
  scene.disk.recipe.points = 100;
  scene.numerics.longest = 0.5;
  EXPECT_NO_THROW(compose(scene));
  scene.disk.file = path;
  EXPECT_INPUT_ERROR(compose(scene), " s on one processor (disk.file), allowed: ");
}

}  // namespace
}  // namespace impact
