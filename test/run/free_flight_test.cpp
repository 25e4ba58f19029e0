#include "run/free_flight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include "lattice/lammps_writing.hpp"
#include "mechanics/simulation.hpp"
#include "run/compose.hpp"

namespace impact {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Two points 1 R from their centre of mass, upright at the angle π/2.
PointArray dumbbell() {
  PointArray points(2, 2);
  points << -1.0, 0.0, 1.0, 0.0;
  return points;
}

/// The force of the wall on one point is none above the height 0.1 R: V₀ exp(−a y) = 10⁻⁶.
WallAbove wall() { return {PotentialWall(1e3, 1e-6 * std::exp(1e3 * 0.1)), kInfinity, 1e-6}; }

Flight flat(double height) { return {height, 0.1, 0.0, 0.0, 0.0, 0.0}; }

TEST(StaysAbove, WithoutSpinTheLowestPointDecides) {
  EXPECT_TRUE(stays_above(dumbbell(), flat(0.101), wall()));
  EXPECT_FALSE(stays_above(dumbbell(), flat(0.099), wall()));
  Flight upright = flat(1.099);
  upright.angle = M_PI / 2;
  EXPECT_FALSE(stays_above(dumbbell(), upright, wall()));
  upright.height = 1.101;
  EXPECT_TRUE(stays_above(dumbbell(), upright, wall()));
}

TEST(StaysAbove, SwingComesOnTop) {
  Flight flight = flat(0.15);
  flight.swing = 0.06;
  EXPECT_FALSE(stays_above(dumbbell(), flight, wall()));
  flight.swing = 0.04;
  EXPECT_TRUE(stays_above(dumbbell(), flight, wall()));
}

TEST(StaysAbove, NeedsAVelocityAwayFromTheWall) {
  Flight flight = flat(5.0);
  flight.velocity = 0.0;
  EXPECT_FALSE(stays_above(dumbbell(), flight, wall()));
}

/// The lowest point is at 0.2 + V t − sin(ω t), in either direction, with V/ω = κ: its least value
/// is 0.2 + κ arccos κ − √(1 − κ²), 0.088 for κ = 0.76 and 0.115 for κ = 0.8.
TEST(StaysAbove, ASpinBringsAnEndDown) {
  for (const bool clockwise : {false, true}) {
    Flight flight = flat(0.2);
    double& spin = clockwise ? flight.clockwise : flight.counter_clockwise;
    spin = 0.1 / 0.76;
    EXPECT_FALSE(stays_above(dumbbell(), flight, wall()));
    spin = 0.1 / 0.8;
    EXPECT_TRUE(stays_above(dumbbell(), flight, wall()));
  }
}

/// One end is down already: turning it up is safe, turning it down is not.
TEST(StaysAbove, TheDirectionOfTheSpinCounts) {
  Flight flight = flat(0.2 + std::sin(0.2));
  flight.angle = 0.2;  // the right end is up, the left end is down
  flight.clockwise = 0.1 / 0.6;
  EXPECT_TRUE(stays_above(dumbbell(), flight, wall()));
  std::swap(flight.clockwise, flight.counter_clockwise);
  EXPECT_FALSE(stays_above(dumbbell(), flight, wall()));
}

TEST(StaysAbove, AllPointsCount) {
  PointArray row(1000, 2);
  row.col(0).setLinSpaced(-1.0, 1.0);
  row.col(1).setZero();
  // ln(1000)/10³ higher.
  EXPECT_FALSE(stays_above(row, flat(0.1065), wall()));
  EXPECT_TRUE(stays_above(row, flat(0.1075), wall()));
}

TEST(StaysAbove, NothingIsFeltAboveTheThreshold) {
  WallAbove low = wall();
  low.threshold = 0.05;
  EXPECT_TRUE(stays_above(dumbbell(), flat(0.051), low));
  EXPECT_FALSE(stays_above(dumbbell(), flat(0.049), low));
}

/// The scene's disk, free of its wall.
struct Flying {
  explicit Flying(const Scene& scene, double mass = 1.0)
      : bodies(make_bodies(scene)),
        body(bodies->disk(), bodies->all[0].triangles, bodies->all[0].flexibility, scene.material,
             std::sqrt(M_PI / static_cast<double>(bodies->disk().points.rows())), mass) {}
  InnerBounds bounds(const InnerMotion& motion) const { return body.bounds(motion); }

  std::shared_ptr<const Bodies> bodies;
  FreeBody body;
};

Flying flight_of(const Scene& scene) { return Flying(scene); }

Scene small_scene() {
  Scene scene;
  scene.disk.recipe.points = 60;
  return scene;
}

/// Of the small disk about its centre of mass.
double inertia() {
  const PointArray points = make_bodies(small_scene())->disk().points;
  return (points.rowwise() - points.colwise().mean()).square().sum() / 60.0;
}

/// The bounds of the energy alone: the energy of the vibrations is what is not that of the spin.
TEST(InnerBounds, WithoutDampingTheSpinIsKept) {
  const Flying flight = flight_of(small_scene());
  const double l = 0.01;
  const double energy = 0.5 * l * l / inertia();
  const InnerBounds spin = flight.bounds({energy, l});
  ASSERT_TRUE(spin.hold);
  // A part of 10⁻³ of the energy is not told from the spin's.
  EXPECT_NEAR(spin.counter_clockwise, l / inertia(), 0.02 * l / inertia());
  EXPECT_GE(spin.counter_clockwise, l / inertia());
  EXPECT_EQ(spin.clockwise, 0.0);
  const InnerBounds other = flight.bounds({energy, -l});
  EXPECT_EQ(other.clockwise, spin.counter_clockwise);
  EXPECT_EQ(other.counter_clockwise, 0.0);
  const InnerBounds vibrating = flight.bounds({2.0 * energy, l});
  EXPECT_GT(vibrating.swing, 5.0 * spin.swing);
}

/// The same motion of a disk of four times the mass: four times the energy of rotation, as much in
/// the bonds. What vibrates has half the frequency, and so twice its angular momentum.
TEST(InnerBounds, OfAHeavyDiskAreThoseOfALightOne) {
  constexpr double kMass = 4.0;
  constexpr double kInBonds = 1e-8;
  const Flying light(small_scene());
  const Flying heavy(small_scene(), kMass);
  constexpr double kMomentum = 1e-3;
  const double rotation = 0.5 * kMomentum * kMomentum / inertia();
  const InnerBounds of_light = light.bounds({rotation + kInBonds, kMomentum});
  const InnerBounds of_heavy = heavy.bounds({kMass * rotation + kInBonds, kMass * kMomentum});
  // Of the energies' difference, up to what √I may have grown by the displacement: 10⁻⁴ of it.
  EXPECT_NEAR(of_heavy.swing / of_light.swing, 1.0, 0.1);
  EXPECT_NEAR(of_heavy.counter_clockwise / of_light.counter_clockwise, 1.0, 1e-3);
  EXPECT_EQ(of_heavy.clockwise, 0.0);
  const InnerBounds light_at_rest = light.bounds({kInBonds, 0.0});
  const InnerBounds heavy_at_rest = heavy.bounds({kInBonds, 0.0});
  EXPECT_NEAR(heavy_at_rest.clockwise / light_at_rest.clockwise, 0.5, 1e-12);
}

TEST(InnerBounds, OfVibrationsGrowWithTheRootOfTheEnergy) {
  const Flying flight = flight_of(small_scene());
  const InnerBounds small = flight.bounds({1e-8, 0.0});
  const InnerBounds large = flight.bounds({1e-6, 0.0});
  EXPECT_NEAR(large.swing / small.swing, 10.0, 0.2);
  EXPECT_GT(small.clockwise, 0.0);
  EXPECT_EQ(small.clockwise, small.counter_clockwise);
}

/// All of the energy may become vibration, or spin in any direction.
TEST(InnerBounds, WithDampingOnlyTheEnergyCounts) {
  Scene scene = small_scene();
  scene.material.eta = 1.0;
  const Flying flight = flight_of(scene);
  const InnerBounds bounds = flight.bounds({1e-5, 1e-9});
  EXPECT_EQ(bounds.clockwise, bounds.counter_clockwise);
  EXPECT_GE(bounds.clockwise, std::sqrt(2e-5 / inertia()));
  EXPECT_EQ(flight.bounds({1e-5, 3e-3}).swing, bounds.swing);
}

/// A stiffer disk swings out less, by the root of its stiffness.
TEST(InnerBounds, ScaleWithTheStiffness) {
  Scene scene = small_scene();
  const double soft = flight_of(scene).bounds({1e-8, 0.0}).swing;
  scene.material.k_a = 4.0;
  EXPECT_NEAR(flight_of(scene).bounds({1e-8, 0.0}).swing / soft, 0.5, 1e-3);
}

TEST(InnerBounds, DoNotHoldWhenOneBondCouldFold) {
  const Flying flight = flight_of(small_scene());
  const double spacing = std::sqrt(M_PI / 60);
  const auto energy = [&](double share) { return 0.5 * std::pow(share * spacing, 2) / 1.1; };
  EXPECT_TRUE(flight.bounds({energy(0.3), 0.0}).hold);
  EXPECT_FALSE(flight.bounds({energy(0.35), 0.0}).hold);
}

/// Of a scene in this state.
double energy_bound(const Scene& scene, const Composition& composition, const State& state) {
  const Simulation system(composition.field, state, composition.rates.lattice, 1e-3);
  return FreeFlight(scene, composition.bodies).energy_bound(system, 1e-4);
}

/// A disk 5 R above a wall that rises as a whole, with this part of the disk's velocity.
double bound_above_rising_wall(double part) {
  Scene scene = small_scene();
  scene.wall.kind = WallKind::kLattice;
  scene.wall.points = 100;
  const Composition composition = compose(scene);
  const Body disk = composition.field.first_body();
  State state = composition.initial;
  state.velocity.col(1) = part * 1e-3;
  disk.rows_of(state.position).col(1) += 5.0;
  disk.rows_of(state.velocity).col(1) = 1e-3;
  return energy_bound(scene, composition, state);
}

TEST(FreeFlight, CountsHowFastAFreeWallRises) {
  EXPECT_LE(bound_above_rising_wall(0.0), 1e-4);
  EXPECT_LE(bound_above_rising_wall(0.1), 1e-4);
  EXPECT_EQ(bound_above_rising_wall(1.1), kInfinity);
}

/// A triangle over one of its sides turns until a corner is down, while it rises up to the time
/// V/g: after a turn by the angle φ its lowest point is at 0.53 + κ φ − g φ²/(2 ω²) − cos(π/3 − φ),
/// κ = V/ω. For κ = 0.9 that rises without gravity, and is −0.08 at the top of a flight that ends
/// after a turn by 0.8.
TEST(FreeFlight, ReachesTheWallIfGravityHoldsItDown) {
  const std::filesystem::path path = testing::TempDir() + "free_flight_test.data";
  PointArray corners(3, 2);
  corners << std::sqrt(0.75), -0.5, 0.0, 1.0, -std::sqrt(0.75), -0.5;
  write_lammps_data(make_lattice(corners, {{0, 1}, {1, 2}, {0, 2}}), 1.0 / 3.0, path);
  constexpr double kVelocity = 1e-4;
  constexpr double kSpin = kVelocity / 0.9;
  Scene scene;
  scene.disk.file = path.string();
  scene.wall.a = 3000.0;
  for (const double gravity : {0.0, kVelocity * kSpin / 0.8}) {
    scene.gravity = gravity;
    const Composition composition = compose(scene);
    State state = composition.initial;
    state.position = corners;
    state.position.col(1) += 0.53;
    state.velocity.col(0) = -kSpin * corners.col(1);
    state.velocity.col(1) = kVelocity + kSpin * corners.col(0);
    const double bound = energy_bound(scene, composition, state);
    if (gravity == 0.0) {
      EXPECT_LE(bound, 1e-4);
    } else {
      EXPECT_EQ(bound, kInfinity);
    }
  }
}

}  // namespace
}  // namespace impact
