#include "run/rates.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "run/expected_time.hpp"
#include "theory/hertz.hpp"

namespace impact {
namespace {

constexpr int kPointsOfDefault = 1099;
constexpr double kSpeedOfSound = 1.9;
const Repulsion kLaw(300.0, 0.27);

/// A disk that is as hard as it gets, and one that is so slow that the wall alone yields: Hertz's
/// pressure and that of a rigid disk, over the spacing, twice.
TEST(LargestPointForce, HasThePressuresOfHertzAndOfARigidDisk) {
  const double v = 1e-7;
  Scene scene;
  scene.impact.velocity = v;
  const double spacing = std::sqrt(M_PI / 1e6);
  const double a = scene.wall.a;
  const double of_wall = 0.5 * a * v * v;
  EXPECT_NEAR(largest_point_force(scene, 1000000, kSpeedOfSound),
              2.0 * spacing * of_wall * std::sqrt(a / (2.0 * M_PI)), 1e-3 * of_wall * spacing);
  scene.impact.velocity = 0.1;
  scene.wall.a = 1e6;
  const double total = M_PI * 0.1 / contact_time_at_most(kSpeedOfSound, 0.1);
  const double hertz = contact_pressure({kSpeedOfSound * kSpeedOfSound / M_PI, 0.0}, total, 0.0);
  constexpr int kMany = 2000000000;  // of which none is stopped by itself
  EXPECT_NEAR(
      largest_point_force(scene, kMany, kSpeedOfSound) / (2.0 * hertz * std::sqrt(M_PI / kMany)),
      1.0, 1e-3);
}

/// Two points that push each other have half the mass of one.
TEST(Rates, CountBothEndsOfAContact) {
  Scene scene;
  const double one_end = rates(scene, {1.0, 0.0}, kLaw, kPointsOfDefault, kSpeedOfSound).wall;
  const double stiffness =
      kLaw.stiffness(largest_point_force(scene, kPointsOfDefault, kSpeedOfSound));
  EXPECT_DOUBLE_EQ(one_end, stiffness * kPointsOfDefault);
  scene.wall.kind = WallKind::kLattice;
  EXPECT_DOUBLE_EQ(rates(scene, {1.0, 0.0}, kLaw, kPointsOfDefault, kSpeedOfSound).wall,
                   2.0 * one_end);
}

/// Those have inertia to spare.
TEST(ContactRate, HasAMarginUnlessTheMethodSolvesForTheBonds) {
  Scene scene;
  const Rates of_scene = rates(scene, {1.0, 0.0}, kLaw, kPointsOfDefault, kSpeedOfSound);
  const double plain = contact_rate(scene, of_scene, IntegratorKind::kImex, 0.01);
  EXPECT_DOUBLE_EQ(contact_rate(scene, of_scene, IntegratorKind::kVerlet, 0.01), 1.5 * plain);
  EXPECT_DOUBLE_EQ(contact_rate(scene, of_scene, IntegratorKind::kModal, 0.01), plain);
  Rates met = of_scene;
  met.met = 100.0;
  EXPECT_EQ(contact_rate(scene, met, IntegratorKind::kImex, 0.01), 100.0);
  EXPECT_EQ(contact_rate(scene, met, IntegratorKind::kVerlet, 0.01), 150.0);
}

}  // namespace
}  // namespace impact
