#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/body_motion.hpp"
#include "series/convergence_study.hpp"

namespace impact {
namespace {

/// The motion along y and the spin.
struct RigidMotion {
  double velocity;
  double spin;
};

/// A rigid disk that one point stops without friction: at the contact's lever arm x about the
/// centre of mass, v_y + ω x turns round by the impulse J = −2 (v_y + ω x)/(1/M + x²/I).
RigidMotion rigid_impact(const Lattice& lattice, const RigidMotion& before) {
  const BodyMotion body = body_motion(lattice.points, PointArray::Zero(lattice.points.rows(), 2));
  Eigen::Index lowest = 0;
  lattice.points.col(1).minCoeff(&lowest);
  const double x = lattice.points(lowest, 0) - body.centre.x();
  const double impulse =
      -2.0 * (before.velocity + before.spin * x) / (1.0 + x * x / body.moment_of_inertia);
  return {before.velocity + impulse, before.spin + x * impulse / body.moment_of_inertia};
}

/// With x = lever arm and k² = I/M, e = (k² − x²)/(k² + x²).
double rigid_restitution(const Lattice& lattice) {
  return rigid_impact(lattice, {-1.0, 0.0}).velocity;
}

class RigidLimit : public testing::TestWithParam<std::uint64_t> {};  // over seeds with x < k

/// On a wall so hard that a second point does not touch it, so slowly that the force changes at the
/// rate a v = 0.1 c/R, far below the lowest frequency: no vibration stays. (At a tenth of the speed
/// e is the same to 10⁻⁷.) While the wall pushes, over some 1/a, the disk turns and changes its
/// lever arm.
TEST_P(RigidLimit, OfASlowDiskWithoutDamping) {
  Scene scene;
  scene.seed = GetParam();
  scene.disk.recipe = {7, Placement::kBlueNoise, false};
  scene.wall.a = 1e5;
  scene.impact.velocity = 1e-6;
  ConvergenceStudy study(scene);
  while (!study.finished()) study.advance();
  const double tolerance = 10.0 / scene.wall.a;
  EXPECT_NEAR(study.answer(), rigid_restitution(study.run().lattice()), tolerance);
  EXPECT_NEAR(study.impact().value.energy_restitution, 1.0, tolerance);
}

/// The same disk, thrown at 40° and spinning so that the point which touches comes faster: then no
/// other point touches after it. While it comes down the 20/a from its start, and while the wall
/// pushes, it turns by some 20 ω/(a v).
TEST_P(RigidLimit, OfASlowDiskThatSpins) {
  Scene scene;
  scene.seed = GetParam();
  scene.disk.recipe = {7, Placement::kBlueNoise, false};
  scene.wall.a = 1e5;
  scene.impact.velocity = 1e-6;
  scene.impact.angle = 40.0;
  const double v = scene.impact.normal_velocity();
  const Lattice disk = make_bodies(scene)->disk();
  const auto after_spin = [&](double spin) { return rigid_impact(disk, {-v, spin}); };
  constexpr double kSpin = 3e-7;
  scene.impact.spin = after_spin(kSpin).velocity > after_spin(-kSpin).velocity ? kSpin : -kSpin;
  const RigidMotion after = after_spin(scene.impact.spin);

  ConvergenceStudy study(scene);
  while (!study.finished()) study.advance();
  const double tolerance = 30.0 / scene.wall.a;
  const Restitution& value = study.impact().value;
  EXPECT_NEAR(value.restitution, after.velocity / v, tolerance);
  EXPECT_NEAR(value.spin_after / v, after.spin / v, tolerance);
  EXPECT_NEAR(value.tangential_velocity_after / scene.impact.tangential_velocity(), 1.0, 1e-9);
  EXPECT_NEAR(value.energy_restitution, 1.0, tolerance);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RigidLimit, testing::Range<std::uint64_t>(2, 7));

}  // namespace
}  // namespace impact
