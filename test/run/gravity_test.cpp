#include <gtest/gtest.h>

#include <cmath>

#include "run/error_control.hpp"
#include "run/run.hpp"

namespace impact {
namespace {

Scene falling(double velocity, double gravity) {
  Scene scene;
  scene.disk.recipe.points = 200;
  scene.impact.velocity = velocity;
  scene.gravity = gravity;
  return scene;
}

Restitution answer_to(const Scene& scene) {
  const auto composition = compose_shared(scene);
  ErrorControl control(scene, *composition);
  control.find_resolution(composition, [] { return false; });
  return control.answer().value;
}

/// Whatever the height from which it fell, what counts is how fast it touches.
TEST(Gravity, TheHeightOfTheStartDoesNotMatter) {
  constexpr double kGravity = 1e-3;
  constexpr double kVelocity = 0.05;
  const auto from = [&](double gap) {
    Scene scene = falling(std::sqrt(kVelocity * kVelocity - 2.0 * kGravity * gap), kGravity);
    scene.impact.gap = gap;
    return answer_to(scene);
  };
  const Restitution low = from(0.1);
  const Restitution high = from(0.9);
  EXPECT_NEAR(low.velocity_before, -kVelocity, 1e-12);
  EXPECT_NEAR(high.velocity_before, -kVelocity, 1e-12);
  EXPECT_NEAR(high.restitution, low.restitution, 2.0 * 1e-4 * low.restitution);
  EXPECT_NEAR(high.contact_duration, low.contact_duration, 1e-3 * low.contact_duration);
}

TEST(Gravity, IsNoneInTheLimit) {
  const double without = answer_to(falling(0.05, 0.0)).restitution;
  const double weak = answer_to(falling(0.05, 1e-5)).restitution;
  // The weight 10⁻⁵ M c²/R against a peak force of some v c = 0.05.
  EXPECT_NEAR(weak, without, 1e-3);
  EXPECT_NE(weak, without);
}

/// The momentum that the wall gave is what the disk has more of, and what its weight took away.
TEST(Gravity, TakesItsPartOfTheMomentum) {
  Scene scene = falling(0.05, 5e-3);
  scene.numerics.step = 0.002;
  impact::Run run(scene);
  const double before = run.disk_state().velocity.col(1).mean();
  while (!run.finished()) run.advance();
  const double change = run.disk_state().velocity.col(1).mean() - before;
  const double impulse = run.take_contact_reports().on_first.impulse;
  // The trapezoidal rule is Verlet's own sum of the forces, but for its two ends, where the wall
  // pushes with 10⁻⁸ of its peak.
  EXPECT_NEAR(impulse, change + scene.gravity * run.system().time(), 1e-9);
  EXPECT_GT(scene.gravity * run.system().time(), 0.02);
}

TEST(Gravity, KeepsTheEnergyInTheLedger) {
  Scene scene = falling(0.05, 5e-3);
  scene.numerics.step = 0.002;
  impact::Run run(scene);
  const double before = run.system().ledger().total();
  while (!run.finished()) run.advance();
  const EnergyLedger after = run.system().ledger();
  EXPECT_NE(after.load, 0.0);
  EXPECT_NEAR(after.total(), before, 1e-3 * after.kinetic());
}

/// The run is over once the disk rises clear of the wall, not when it comes down again.
TEST(Gravity, EndsBeforeTheDiskFallsBack) {
  Scene scene = falling(0.05, 2e-3);
  scene.numerics.step = 0.005;
  impact::Run run(scene);
  while (!run.finished()) run.advance();
  EXPECT_FALSE(run.has_flag(Flag::kNotSeparated));
  const double v = run.disk_state().velocity.col(1).mean();
  EXPECT_GT(v, 0.0);
}

/// What does not rise clear of the wall has no e.
TEST(Gravity, AHeavyDampedDiskStays) {
  Scene scene = falling(0.01, 0.05);
  scene.material.eta = 10.0;
  scene.numerics.step = 0.002;
  impact::Run run(scene);
  while (!run.finished()) run.advance();
  EXPECT_TRUE(run.has_flag(Flag::kNotSeparated));
}

}  // namespace
}  // namespace impact
