#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <utility>

#include "lattice/input_error.hpp"
#include "lattice/lammps_writing.hpp"
#include "mechanics/body_motion.hpp"
#include "mechanics/simulation.hpp"
#include "run/compose.hpp"
#include "run/row_of_disks.hpp"
#include "run/run.hpp"

namespace impact {
namespace {

/// At this velocity against each other, with a step of its own.
Scene pair_of_disks(double velocity) {
  Scene scene;
  scene.disk.recipe.points = 200;
  scene.wall.kind = WallKind::kDisk;
  scene.impact.velocity = velocity;
  scene.numerics.step = 0.005;
  return scene;
}

void finish(impact::Run& run) {
  while (!run.finished()) run.advance();
}

Restitution result_of(const Scene& scene) {
  impact::Run run(scene);
  ImpactAnalysis analysis;
  run.show(analysis);
  finish(run);
  run.show(analysis);
  analysis.add(run.take_contact_reports().on_first);
  return analysis.restitution(true);
}

BodyMotion motion_of(const State& state) { return body_motion(state.position, state.velocity); }

/// About the origin, in units of the point mass.
double angular_momentum(const State& state) {
  return (state.position.col(0) * state.velocity.col(1) -
          state.position.col(1) * state.velocity.col(0))
      .sum();
}

TEST(DiskOnDisk, StartsFromTheCentreOfMassOfBoth) {
  Scene scene = pair_of_disks(0.1);
  scene.wall.radius = 2.0;
  scene.impact.angle = 30.0;
  const impact::Run run(scene);
  EXPECT_EQ(run.bodies()[1].lattice.points.rows(), 800);
  EXPECT_LT(run.state().velocity.colwise().sum().abs().maxCoeff(), 1e-12);  // of 1000 points
  const Eigen::Array2d approach =
      motion_of(run.disk_state()).velocity - motion_of(run.state_of(1)).velocity;
  EXPECT_NEAR(approach.x(), 0.05, 1e-15);
  EXPECT_NEAR(approach.y(), -0.1 * std::cos(M_PI / 6.0), 1e-15);
  EXPECT_NEAR(motion_of(run.disk_state()).velocity.x(), 0.8 * 0.05, 1e-15);
}

TEST(DiskOnDisk, KeepsMomentumAngularMomentumAndEnergy) {
  Scene scene = pair_of_disks(0.1);
  scene.wall.radius = 1.4;
  scene.wall.k_a = 0.5;
  scene.impact.angle = 40.0;
  scene.impact.spin = 0.05;
  impact::Run run(scene);
  const double before = angular_momentum(run.state());
  finish(run);
  // Rounding of a thousand steps: √1000 · 10⁻¹⁶ of the size of the terms, 592 points of 0.1 c each.
  EXPECT_LT(run.state().velocity.colwise().sum().abs().maxCoeff(), 1e-12);
  EXPECT_NEAR(angular_momentum(run.state()), before, 1e-11);
  EXPECT_LT(run.energy_error(), 1e-4);
  // Of Verlet it goes with the square of the step, where forces turn in dents with the step.
  scene.numerics.step = 0.000625;
  impact::Run finer(scene);
  finish(finer);
  EXPECT_LT(finer.energy_error(), 0.5 * run.energy_error());
}

/// What the disk does to its mirror image, it does to the plane between: the gap to the image is
/// twice the height above the plane, as long as the outline is level where it is within reach of
/// it. So the pair with the repulsion a is one disk on a potential wall with 2 a.
class MirroredPair : public testing::TestWithParam<double> {};  // over the velocity of each

TEST_P(MirroredPair, MeetsLikeADiskAndAWall) {
  Scene pair = pair_of_disks(2.0 * GetParam());
  pair.wall.mirrored = true;
  Scene one = pair_of_disks(GetParam());
  one.wall.kind = WallKind::kPotential;
  one.wall.a = 2.0 * pair.wall.a;
  const Restitution of_pair = result_of(pair);
  const Restitution of_one = result_of(one);
  // The outline's slope s = 0.1 … 0.2 within the contact makes the gap shorter by s²/2, some 10⁻²
  // of a few ranges 1/(2 a) of the wall, 10⁻³ R: a change of the shape by 10⁻⁵ R.
  EXPECT_NEAR(of_pair.restitution, of_one.restitution, 5e-5);
  EXPECT_NEAR(of_pair.velocity_before, of_one.velocity_before, 1e-15);
  EXPECT_NEAR(of_pair.contact_duration, of_one.contact_duration, 1e-3 * of_one.contact_duration);
  EXPECT_NEAR(of_pair.peak_force, of_one.peak_force, 1e-3 * of_one.peak_force);
  EXPECT_NEAR(of_pair.spin_after, of_one.spin_after, 5e-5 * GetParam() / 0.01);
  EXPECT_NEAR(of_pair.rotation_energy, of_one.rotation_energy, 5e-5);
}

INSTANTIATE_TEST_SUITE_P(Velocities, MirroredPair, testing::Values(0.003, 0.01, 0.05));

TEST(DiskOnDisk, MirrorImagesStayMirrorImages) {
  Scene scene = pair_of_disks(0.1);
  scene.wall.mirrored = true;
  impact::Run run(scene);
  finish(run);
  PointArray image = run.state_of(1).velocity;
  image.col(1) *= -1.0;
  // Rounding that some hundred steps on stiff contacts amplify.
  EXPECT_LT((image - run.disk_state().velocity).abs().maxCoeff(), 1e-11);
}

/// Files of two lattices and of both turned by 180°.
class ExchangedDisks : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / "lattice_impact_exchanged";
    std::filesystem::create_directories(folder_);
    write("a", 1, 200, 1.0);
    write("b", 2, 260, 1.15);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Scene scene(const std::string& first, const std::string& second) const {
    Scene scene = pair_of_disks(0.06);
    scene.impact.angle = 20.0;
    scene.disk.file = file(first);
    scene.wall.file = file(second);
    scene.wall.v0 = 1.0;
    scene.impact.gap = 0.1;
    return scene;
  }

 private:
  std::string file(const std::string& name) const { return folder_ / (name + ".data"); }
  void write(const std::string& name, std::uint64_t seed, int points, double radius) const {
    Scene recipe;
    recipe.seed = seed;
    recipe.disk.recipe.points = points;
    Lattice lattice = make_bodies(recipe)->disk();
    lattice = make_lattice(radius * lattice.points, lattice.bonds);
    write_lammps_data(lattice, 1.0, file(name));
    write_lammps_data(make_lattice(-lattice.points, lattice.bonds), 1.0, file(name + "_turned"));
  }

  std::filesystem::path folder_;
};

/// Seen upside down, the second disk is the first. Units are those of the disk of 200 points in
/// the one case and of 260 in the other, whose point masses 1/200 and 1/260 M must be told.
TEST_F(ExchangedDisks, BounceOffEachOtherAlike) {
  const Scene one = scene("a", "b");
  Scene other = scene("b_turned", "a_turned");
  // c² = k_a R²/M: with 1.3 times the mass and the same constants in it, k_a counts as 1.3.
  const double mass = 1.3;
  other.material.k_a /= mass;
  other.material.k_b /= mass;
  other.wall.v0 = *one.wall.v0 / mass;
  const Restitution of_one = result_of(one);
  const Restitution of_other = result_of(other);
  // Rounding of the files' digits and of the contacts of both.
  EXPECT_NEAR(of_other.restitution, of_one.restitution, 1e-9);
  EXPECT_NEAR(of_other.energy_restitution, of_one.energy_restitution, 1e-9);
}

TEST(DiskOnDisk, TouchesAtTheTopAlsoObliquely) {
  Scene scene = pair_of_disks(0.05);
  scene.impact.angle = 60.0;
  scene.impact.gap = 0.1;
  impact::Run run(scene);
  const double off =
      run.lattice().points.col(0).mean() - run.bodies()[1].lattice.points.col(0).mean();
  const auto offset = [&] {
    return motion_of(run.disk_state()).centre.x() - motion_of(run.state_of(1)).centre.x() - off;
  };
  // One point of a pair of reduced mass ½ holds the energy of the motion along y at this gap, and
  // until there nothing slows the disks down by much.
  const double energy = 0.25 * std::pow(scene.impact.normal_velocity(), 2);
  const double gap = run.system().field().contact()->gap_of_energy(energy);
  const double way = 0.1 - gap;
  EXPECT_NEAR(offset(), -way * std::tan(M_PI / 3.0), 1e-12);
  while (run.system().time() < way / scene.impact.normal_velocity() - 0.5 * 0.02) run.advance();
  // In an output period they slide by 9·10⁻⁴ R; what the repulsion has slowed down is as little.
  EXPECT_NEAR(offset(), 0.0, 2e-3);
}

/// It has flown longer along the same line.
TEST(DiskOnDisk, StartsHigherOnTheWayToTheSameTouch) {
  Scene scene = pair_of_disks(0.05);
  scene.impact.angle = 60.0;
  const Composition composition = compose(scene);
  Resolution higher = composition.resolution;
  higher.lift = 0.3;
  const Eigen::Array2d lifted =
      start_of(composition, higher).position.row(0) - composition.initial.position.row(0);
  EXPECT_NEAR(lifted.y(), 0.3, 1e-15);
  EXPECT_NEAR(lifted.x(), -0.3 * std::tan(M_PI / 3.0), 1e-14);
}

/// The run ends when the disks cannot meet again: followed for long after, they do not.
TEST(DiskOnDisk, EndsWhenTheyPartForGood) {
  Scene scene = pair_of_disks(0.1);
  scene.impact.angle = 50.0;
  scene.impact.spin = 0.1;
  impact::Run run(scene);
  finish(run);
  EXPECT_FALSE(run.has_flag(Flag::kNotSeparated));
  const ForceField& field = run.system().field();
  Simulation on(field, run.state(), lattice_spectrum(run.lattice(), {1.0, 1e-3, 0.0}, 1.0 / 200.0),
                0.005);
  const double v = motion_of(run.disk_state()).velocity.y();
  const double limit = 1e-2 * scene.numerics.error * field.impact_energy(v);
  for (int step = 0; step < 4000; ++step) {
    on.step();
    const Contact& contact = *on.field().contact();
    ASSERT_LT(contact.potential_energy(on.state().position), limit);
  }
}

TEST(DiskOnDisk, WithTheSameSpeedsADampedPairLosesMore) {
  Scene scene = pair_of_disks(0.05);
  const double without = result_of(scene).restitution;
  scene.wall.eta = 3.0;
  const double one_damped = result_of(scene).restitution;
  scene.material.eta = 3.0;
  const double both_damped = result_of(scene).restitution;
  EXPECT_LT(one_damped, without - 0.01);
  EXPECT_LT(both_damped, one_damped - 0.01);
}

TEST(SecondDisk, IsBalancedOnceTheFirstOneIs) {
  Scene scene = pair_of_disks(0.05);
  scene.disk.orientation = Orientation::kBalanced;
  const auto bodies = make_bodies(scene);
  Eigen::Index highest = 0;
  bodies->all[1].lattice.points.col(1).maxCoeff(&highest);
  EXPECT_NEAR(bodies->all[1].lattice.points(highest, 0), 0.0, 1e-12);
  EXPECT_NEAR(bodies->all[1].lattice.points.col(0).mean(), 0.0, 1e-12);
}

TEST(SecondDisk, HasAClosedOutline) {
  Scene scene = pair_of_disks(0.05);
  const Lattice lattice = make_bodies(scene)->disk();
  const auto outline = closed_outline(lattice.points, 7);
  EXPECT_EQ(outline.front(), outline.back());
  double area = 0.0;
  for (std::size_t k = 0; k + 1 < outline.size(); ++k) {
    const auto a = lattice.points.row(outline[k] - 7);
    const auto b = lattice.points.row(outline[k + 1] - 7);
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  const auto sides = static_cast<double>(outline.size() - 1);
  // Of a regular polygon with as many corners, clockwise.
  EXPECT_NEAR(area, -0.5 * sides * std::sin(2.0 * M_PI / sides), 1e-9);
}

TEST(SecondDisk, NamesAFileThatCannotBeUsed) {
  Scene scene = pair_of_disks(0.05);
  scene.wall.file = "no_such.data";
  EXPECT_THROW(make_bodies(scene), InputError);
}

}  // namespace
}  // namespace impact
