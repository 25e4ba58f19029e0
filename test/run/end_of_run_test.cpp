#include "run/end_of_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "mechanics/simulation.hpp"
#include "run/make_integrator.hpp"
#include "run/run.hpp"
#include "statics/equilibrium_solver.hpp"

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

/// A collision that goes on after its end.
class EndlessCollision {
 public:
  explicit EndlessCollision(const Scene& scene)
      : composition_(compose(scene)),
        end_(end_of_run(scene, composition_, composition_.resolution.step)),
        simulation_(
            composition_.field, composition_.initial, composition_.rates.lattice,
            composition_.resolution.step,
            make_integrator(scene, composition_.resolution, composition_.rates.sound_speed)) {}

  /// False when the end does not come.
  bool go_to_the_end() {
    while (!end_->reached(simulation_)) {
      simulation_.step();
      if (time() > Run::kPatience * composition_.expected_time + end_->time_under_way()) {
        return false;
      }
    }
    return true;
  }

  /// The greatest wall energy up to this time, over the bound that was known at the end.
  double greatest_wall_energy(double time_of_end) {
    const double v = velocity();
    double greatest = 0.0;
    while (time() < time_of_end) {
      simulation_.step();
      const Contact& wall = *simulation_.field().contact();
      greatest = std::max(greatest, wall.total_force().y() / wall.a());
    }
    return greatest / (end_->remaining_energy() * 0.5 * v * v);
  }

  double time() const { return simulation_.time(); }
  /// Of the centre of mass of the disk along y.
  double velocity() const {
    return simulation_.state()
        .velocity.col(1)
        .head(composition_.bodies->disk().points.rows())
        .mean();
  }
  const Simulation& simulation() const { return simulation_; }

 private:
  Composition composition_;
  std::unique_ptr<EndOfRun> end_;
  Simulation simulation_;
};

double restitution_at_the_end(const Scene& scene) {
  EndlessCollision collision(scene);
  EXPECT_TRUE(collision.go_to_the_end());
  return collision.velocity() / scene.impact.velocity;
}

/// They strike again long after they left, since they spin. The values are those of runs that go on
/// ten times as long; at the first steps of `auto` their errors are below 2·10⁻³.
TEST(SeparationEnd, WaitsForTheSecondStrikeOfASpinningDisk) {
  Scene triangle;
  triangle.seed = 3;
  triangle.disk.recipe.points = 3;
  triangle.impact.velocity = 0.05;
  EXPECT_NEAR(restitution_at_the_end(triangle), 0.9056, 2e-3);
  Scene small;
  small.seed = 443148;
  small.disk.recipe.points = 15;
  small.disk.recipe.rim = false;
  small.impact.velocity = 0.0384105;
  small.wall.a = 622.791;
  EXPECT_NEAR(restitution_at_the_end(small), 0.7541, 2e-3);
}

/// Disks of 3 … 60 points of all recipes, at 0.01 … 0.3 c, on walls of a = 50 … 2000, one in three
/// damped.
Scene random_collision(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto logarithmic = [&random](double least, double most) {
    return least * std::pow(most / least, std::uniform_real_distribution<>()(random));
  };
  Scene scene;
  scene.seed = seed;
  scene.disk.recipe.points = static_cast<int>(logarithmic(3.0, 61.0));
  scene.disk.recipe.placement = random() % 2 == 0 ? Placement::kBlueNoise : Placement::kUniform;
  scene.disk.recipe.rim = random() % 2 == 0;
  scene.impact.velocity = logarithmic(0.01, 0.3);
  scene.wall.a = logarithmic(50.0, 2000.0);
  if (random() % 3 == 0) scene.material.eta = logarithmic(0.01, 10.0);
  return scene;
}

/// A disk that keeps 10⁻⁴ of its energy: the energy of the wall that may come is negligible against
/// that, not against what the disk had before.
TEST(SeparationEnd, MeasuresTheTailByWhatComesOut) {
  EndlessCollision collision(random_collision(225));
  ASSERT_TRUE(collision.go_to_the_end());
  const double e = collision.velocity() / random_collision(225).impact.velocity;
  EXPECT_LT(e, 0.02);
  EXPECT_LT(collision.greatest_wall_energy(2.0 * collision.time()), 1.0);
}

class SeparationEndOf : public testing::TestWithParam<Scene> {};

TEST_P(SeparationEndOf, CollisionIsForGood) {
  EndlessCollision collision(GetParam());
  ASSERT_TRUE(collision.go_to_the_end());
  EXPECT_GT(collision.velocity(), 0.0);
  EXPECT_LT(collision.greatest_wall_energy(10.0 * collision.time()), 1.0);
}

/// A disk that is nearly calm is known to be gone soon after the wall has let it go: its lowest
/// point is less than 0.065 R above where the wall's energy is negligible, of which ln(100)/a =
/// 0.015 R for the hundredth part that may remain.
TEST(SeparationEnd, DoesNotLetACalmDiskFlyFar) {
  Scene scene;
  scene.numerics.integrator = IntegratorKind::kVerlet;
  for (const double velocity : {0.003, 0.01, 0.05}) {
    scene.impact.velocity = velocity;
    EndlessCollision collision(scene);
    ASSERT_TRUE(collision.go_to_the_end());
    const PointArray& position = collision.simulation().state().position;
    const double negligible = collision.simulation().field().wall->height_of_energy(
        position, negligible_wall_energy(scene));
    EXPECT_LT(position.col(1).minCoeff(), negligible + 0.065) << velocity;
  }
}

INSTANTIATE_TEST_SUITE_P(Walls, SeparationEndOf,
                         testing::Values(small_collision(), small_collision_with_a_lattice()));

TEST(SeparationEnd, OfRandomDisksIsForGood) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    EndlessCollision collision(random_collision(seed));
    ASSERT_TRUE(collision.go_to_the_end()) << seed;
    EXPECT_LT(collision.greatest_wall_energy(10.0 * collision.time()), 1.0) << seed;
  }
}

/// The same above elastic walls of all boundaries; the walls of some fold, and keep energy in
/// folds.
TEST(SeparationEnd, OfRandomDisksAboveElasticWallsIsForGood) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    for (const Boundary boundary : {Boundary::kReset, Boundary::kFixed, Boundary::kViscous}) {
      Scene scene = random_collision(seed);
      scene.disk.recipe.points += 20;
      scene.wall.kind = WallKind::kLattice;
      scene.wall.points = 3 * scene.disk.recipe.points / 2;
      scene.wall.boundary = boundary;
      EndlessCollision collision(scene);
      ASSERT_TRUE(collision.go_to_the_end()) << seed;
      EXPECT_LT(collision.greatest_wall_energy(3.0 * collision.time()), 1.0) << seed;
    }
  }
}

/// A hundredth of the error of the force k_a x + k_b x³ on a bond of √(π/N) R.
TEST(NegligibleStaticForce, OfAStretchGoesWithTheStiffnessOfABond) {
  Scene scene;
  scene.kind = SceneKind::kStretch;
  scene.disk.recipe.points = 100;
  scene.material.k_b = 1e3;
  scene.stretch.strain = 0.1;
  const double x = 0.1 * std::sqrt(M_PI / 100);
  EXPECT_DOUBLE_EQ(negligible_static_force(scene, 100, 1.0),
                   (1.0 + 3.0 * 1e3 * x * x) * 0.01 * 1e-4 * x);
}

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

TEST(StaticEnd, IsReachedOnlyAtRest) {
  Scene scene;
  scene.kind = SceneKind::kContact;
  scene.disk.recipe.points = 60;
  const Composition composition = compose(scene);
  const auto end = end_of_run(scene, composition, composition.resolution.step);
  EquilibriumSearch search(composition.field, composition.initial, 1e-5 * scene.load.p / 60);
  EXPECT_FALSE(end->reached(search));
  ASSERT_TRUE(solve(search));
  EXPECT_TRUE(end->reached(search));
}

}  // namespace
}  // namespace impact
