#include "run/compose.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "expect_input_error.hpp"
#include "lattice/lammps_writing.hpp"
#include "lattice/placement.hpp"

namespace impact {
namespace {

using Names = std::vector<std::string>;

/// The energy of the wall half an R/c of flight at 0.01 c before it is the negligible one.
const double kBeforeNegligible = std::exp(-300.0 * 0.01 * 0.5);

Scene contact_scene() {
  Scene scene;
  scene.kind = SceneKind::kContact;
  scene.material.eta = 100.0;
  scene.numerics.integrator = IntegratorKind::kVerlet;
  return scene;
}

Names terms(const Scene& scene) { return compose(scene).field.terms(); }

TEST(Compose, BuildsOnlyTheTermsOfACollision) {
  const std::tuple<double, double, const char*> laws[] = {{0.0, 0.0, "bonds"},
                                                          {1e-3, 0.0, "bonds (cubic)"},
                                                          {0.0, 1.0, "bonds (damped)"},
                                                          {1e-3, 1.0, "bonds (cubic, damped)"}};
  for (const auto& [k_b, eta, bonds] : laws) {
    Scene scene;
    scene.material.k_b = k_b;
    scene.material.eta = eta;
    const Composition composition = compose(scene);
    EXPECT_EQ(composition.field.terms(), (Names{bonds, "potential wall"}));
    EXPECT_TRUE(composition.bodies->is_alone());
    EXPECT_EQ(composition.field.other_points(), 0);
    EXPECT_EQ(composition.initial.position.rows(), 1099);
  }
}

TEST(Compose, BuildsOnlyTheTermsOfAContact) {
  Names names{"bonds (cubic, damped)", "potential wall", "compression load", "rotation hold"};
  Scene scene = contact_scene();
  EXPECT_EQ(terms(scene), names);
  scene.load.hold_rotation = false;
  names.pop_back();
  EXPECT_EQ(terms(scene), names);
}

TEST(Compose, RefusesDisksThatAreForLammpsOnly) {
  Scene scene;
  scene.disk.recipe.points = 1000001;
  EXPECT_INPUT_ERROR(compose(scene), "disk.points: got 1000001, allowed: at most 1000000");
}

/// Over the lowest point to rounding, in a lattice of the same bonds with the same lengths.
TEST(Compose, BalancesTheDisk) {
  Scene scene;
  const Lattice random = make_bodies(scene)->disk();
  scene.disk.orientation = Orientation::kBalanced;
  const Lattice balanced = make_bodies(scene)->disk();
  Eigen::Index lowest = 0;
  balanced.points.col(1).minCoeff(&lowest);
  EXPECT_NEAR(balanced.points(lowest, 0), balanced.points.col(0).mean(), 1e-14);
  ASSERT_EQ(balanced.natural_lengths.size(), random.natural_lengths.size());
  for (std::size_t k = 0; k < random.natural_lengths.size(); ++k) {
    EXPECT_NEAR(balanced.natural_lengths[k], random.natural_lengths[k], 1e-14);
  }
}

/// Nothing moves, so nothing is damped.
TEST(Compose, BuildsNoDampingForAStaticContact) {
  Scene scene = contact_scene();
  scene.numerics.integrator = IntegratorKind::kNewton;
  const Composition composition = compose(scene);
  EXPECT_EQ(composition.field.terms(),
            (Names{"bonds (cubic)", "potential wall", "compression load", "rotation hold"}));
  EXPECT_FALSE(composition.field.damped());
}

Scene elastic_wall_scene(Boundary boundary) {
  Scene scene;
  scene.wall.kind = WallKind::kLattice;
  scene.wall.boundary = boundary;
  return scene;
}

TEST(Compose, BuildsTheBoundaryOfTheElasticWall) {
  EXPECT_EQ(terms(elastic_wall_scene(Boundary::kReset)),
            (Names{"bonds (cubic)", "elastic wall", "velocity reset"}));
  EXPECT_EQ(terms(elastic_wall_scene(Boundary::kFixed)),
            (Names{"bonds (cubic)", "elastic wall", "supports"}));
  EXPECT_EQ(terms(elastic_wall_scene(Boundary::kViscous)),
            (Names{"bonds (cubic)", "elastic wall", "viscous boundary"}));
  Scene damped = elastic_wall_scene(Boundary::kFixed);
  damped.material.k_b = 0.0;
  damped.material.eta = 1.0;
  EXPECT_EQ(terms(damped), (Names{"bonds (damped)", "elastic wall", "supports"}));
}

TEST(Compose, BuildsOnlyBondsAndGripsForAStretch) {
  Scene scene;
  scene.kind = SceneKind::kStretch;
  scene.material.eta = 1.0;  // nothing moves, so nothing is damped
  const Composition composition = compose(scene);
  EXPECT_EQ(composition.field.terms(), (Names{"bonds (cubic)", "supports"}));
  EXPECT_EQ(composition.field.contact(), nullptr);
  EXPECT_TRUE(composition.bodies->is_alone());
  // 4 R × 2 R at the density of 1099 points in a disk.
  EXPECT_EQ(composition.bodies->disk().points.rows(), 2799);
  const Supports& grips = *composition.field.supports;
  EXPECT_TRUE(grips.held(1).empty());
  for (const std::int32_t point : grips.held(0)) {
    EXPECT_NEAR(std::abs(composition.initial.position(point, 0)), 2.0 * 1.001, 1e-12);
  }
  EXPECT_EQ((composition.bodies->disk().points.col(0).abs() == 2.0).count(), grips.held(0).size());
}

/// The disk's points come first, then the wall's, which rests with its surface at y = 0.
TEST(Compose, PutsTheDiskAboveTheElasticWall) {
  const Scene scene = elastic_wall_scene(Boundary::kReset);
  const Composition composition = compose(scene);
  ASSERT_EQ(composition.bodies->all.size(), 2U);
  EXPECT_EQ(composition.field.other_points(), 1269);
  ASSERT_EQ(composition.initial.position.rows(), 1099 + 1269);
  const PointArray& position = composition.initial.position;
  EXPECT_TRUE((position.bottomRows(1269) == composition.bodies->all[1].lattice.points).all());
  EXPECT_EQ(position.col(1).tail(1269).maxCoeff(), 0.0);
  EXPECT_TRUE((composition.initial.velocity.bottomRows(1269) == 0.0).all());
  EXPECT_TRUE((composition.initial.velocity.col(1).head(1099) == -0.01).all());
  // Lengths rounded by 10⁻¹⁶.
  EXPECT_LT(composition.field.bonds.potential_energy(position), 1e-28);
  // Above a flat surface the elastic wall is the potential wall, but for what points further than
  // the threshold of 0.2 R would add, e⁻⁶⁰ of V₀ each.
  // It starts up to a reset of 0.004 R/c earlier.
  const double energy =
      composition.field.elastic_wall->potential_energy(position) / negligible_wall_energy(scene);
  EXPECT_LE(energy, kBeforeNegligible * (1.0 + 1e-9));
  EXPECT_GE(energy, kBeforeNegligible * std::exp(-300.0 * 0.01 * 0.004) * (1.0 - 1e-9));
  const double way = (position.col(1).head(1099).minCoeff()) / (0.01 * 0.004);
  EXPECT_NEAR(way, std::round(way), 1e-9);
}

/// The same disk as without an elastic wall.
TEST(Compose, DoesNotChangeTheDiskForAnElasticWall) {
  const Composition composition = compose(elastic_wall_scene(Boundary::kFixed));
  EXPECT_TRUE((composition.bodies->disk().points == compose(Scene{}).bodies->disk().points).all());
}

/// On the left, right and bottom side both coordinates, on the top none but the corners'.
TEST(Compose, ClampsThreeSidesOfAFixedWall) {
  const Composition composition = compose(elastic_wall_scene(Boundary::kFixed));
  const PointArray& wall = composition.bodies->all[1].lattice.points;
  const double side = wall.col(0).maxCoeff();
  const double bottom = wall.col(1).minCoeff();
  const Supports& clamps = *composition.field.supports;
  EXPECT_EQ(clamps.held(0), clamps.held(1));
  EXPECT_EQ((wall.col(0).abs() == side || wall.col(1) == bottom).count(), clamps.held(0).size());
  for (const std::int32_t point : clamps.held(0)) {
    const auto place = wall.row(point - 1099);
    EXPECT_TRUE(std::abs(place.x()) == side || place.y() == bottom) << place;
  }
}

/// The dashpots count in the stability limit.
TEST(Compose, AddsTheDashpotsToTheSpectrum) {
  const Composition fixed = compose(elastic_wall_scene(Boundary::kFixed));
  const Composition viscous = compose(elastic_wall_scene(Boundary::kViscous));
  EXPECT_EQ(fixed.rates.lattice.gamma, 0.0);
  EXPECT_DOUBLE_EQ(viscous.rates.lattice.gamma,
                   1099 * viscous.field.viscous_boundary->largest_coefficient());
  EXPECT_EQ(viscous.rates.lattice.omega_squared, fixed.rates.lattice.omega_squared);
}

TEST(Compose, SaysThatAStretchedRectangleHasTooFewPoints) {
  Scene scene;
  scene.kind = SceneKind::kStretch;
  scene.disk.recipe.points = 10;
  scene.stretch.width = 10.0;
  scene.stretch.height = 0.1;
  EXPECT_INPUT_ERROR(compose(scene), "stretch: ");
}

/// 3·10⁹ points, more than an int can count, and 1.4·10⁶.
TEST(Compose, SaysThatAStretchedRectangleHasTooManyPoints) {
  Scene scene;
  scene.kind = SceneKind::kStretch;
  scene.disk.recipe.points = 10000;
  scene.stretch.width = scene.stretch.height = 1000.0;
  EXPECT_INPUT_ERROR(compose(scene), "stretch: a 1000 by 1000 R rectangle");
  scene.disk.recipe.points = 1099;
  scene.stretch.width = 4.0;
  EXPECT_INPUT_ERROR(compose(scene), "stretch: a 4 by 1000 R rectangle");
}

TEST(Compose, StartsACollisionWhereTheWallIsNegligible) {
  const Scene scene;
  const Composition composition = compose(scene);
  EXPECT_NEAR(composition.field.wall->potential_energy(composition.initial.position) /
                  negligible_wall_energy(scene),
              kBeforeNegligible, 1e-9);
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
  EXPECT_EQ(first.bodies->disk().bonds, second.bodies->disk().bonds);
  EXPECT_EQ(first.rates.lattice.omega_squared, second.rates.lattice.omega_squared);
  EXPECT_EQ(first.resolution.step, second.resolution.step);
}

TEST(Compose, TakesALatticeFromAFile) {
  const std::filesystem::path path = testing::TempDir() + "compose_test.data";
  const Composition original = compose(Scene{});
  write_lammps_data(original.bodies->disk(), 1.0 / 1099, path);
  Scene scene;
  scene.disk.file = path.string();
  scene.disk.recipe.points = 5;  // replaced by the file
  const Composition again = compose(scene);
  EXPECT_TRUE((again.initial.position == original.initial.position).all());
  EXPECT_EQ(again.resolution.step, original.resolution.step);
  scene.disk.file = "/nowhere/lattice.data";
  EXPECT_INPUT_ERROR(compose(scene), "/nowhere/lattice.data: cannot be read");
}

TEST(Compose, ScalesAFileToRadiusOneOnRequest) {
  const std::filesystem::path path = testing::TempDir() + "compose_test.data";
  const Lattice disk = triangulated_lattice(place_in_disk({100, Placement::kBlueNoise, true}, 1));
  write_lammps_data(make_lattice(3.5 * disk.points, disk.bonds), 0.01, path);
  Scene scene;
  scene.disk.file = path.string();
  EXPECT_INPUT_ERROR(compose(scene), "the radius is 3.5");
  scene.disk.scale = FileScale::kRadius;
  const PointArray points = compose(scene).bodies->disk().points;
  const auto from_middle = points.rowwise() - points.colwise().mean();
  EXPECT_NEAR(from_middle.square().rowwise().sum().maxCoeff(), 1.0, 1e-14);
}

/// Four points in a square: with one diagonal stiff, without it none holds a load.
TEST(Compose, FlagsAFloppyLatticeAndRefusesToPressIt) {
  const std::filesystem::path path = testing::TempDir() + "compose_test.data";
  PointArray points(4, 2);
  points << 1.0, 0.1, -0.1, 1.0, -1.0, -0.1, 0.1, -1.0;
  const std::vector<Bond> sides{{0, 1}, {1, 2}, {2, 3}, {0, 3}};
  write_lammps_data(make_lattice(points, sides), 0.25, path);
  Scene scene;
  scene.disk.file = path.string();
  EXPECT_EQ(compose(scene).bodies->flags, std::vector<std::string>{"floppy"});
  scene.kind = SceneKind::kContact;
  EXPECT_INPUT_ERROR(compose(scene), "the lattice is floppy");

  std::vector<Bond> braced = sides;
  braced.push_back({0, 2});
  write_lammps_data(make_lattice(points, braced), 0.25, path);
  EXPECT_TRUE(compose(scene).bodies->flags.empty());
}

}  // namespace
}  // namespace impact
