#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "lattice/input_error.hpp"
#include "mechanics/body_motion.hpp"
#include "run/error_control.hpp"
#include "run/run.hpp"
#include "run/spinning_shape.hpp"

namespace impact {
namespace {

/// With a step of its own, so that scenes which say the same in other words make the same steps.
Scene thrown(double velocity, double angle, double spin) {
  Scene scene;
  scene.disk.recipe.points = 200;
  scene.impact.velocity = velocity;
  scene.impact.angle = angle;
  scene.impact.spin = spin;
  scene.numerics.step = 0.005;
  return scene;
}

Restitution result_of(impact::Run run) {
  ImpactAnalysis analysis;
  analysis.add(run.disk_state());
  while (!run.finished()) run.advance();
  analysis.add(run.disk_state());
  analysis.add(run.take_contact_reports().on_first);
  return analysis.restitution(true);
}

/// Of each result: a rounding of 10⁻¹⁶ that many contacts amplify.
constexpr double kRounding = 1e-10;

class ThrownAtThePotentialWall : public testing::TestWithParam<double> {};  // over η*

/// The wall pushes along y alone, and bonds know only differences of positions and velocities: what
/// comes along x goes on, and nothing else knows of it.
TEST_P(ThrownAtThePotentialWall, AnImpactDependsOnTheNormalVelocityAlone) {
  const auto result = [](double velocity, double angle) {
    Scene scene = thrown(velocity, angle, 0.0);
    scene.material.eta = GetParam();
    return result_of(impact::Run(scene));
  };
  const Restitution straight = result(0.05, 0.0);
  const Restitution oblique = result(0.1, 60.0);
  EXPECT_NEAR(oblique.restitution, straight.restitution, kRounding);
  EXPECT_NEAR(oblique.contact_duration, straight.contact_duration, kRounding);
  EXPECT_NEAR(oblique.spin_after, straight.spin_after, kRounding);
  EXPECT_NEAR(oblique.tangential_velocity_after, 0.1 * std::sin(M_PI / 3.0), kRounding);
  EXPECT_NEAR(oblique.impulse_ratio, 0.0, kRounding);
}

INSTANTIATE_TEST_SUITE_P(Damping, ThrownAtThePotentialWall, testing::Values(0.0, 10.0));

TEST(ObliqueImpact, OfTheMirrorImageIsTheMirrorImage) {
  const Scene scene = thrown(0.05, 30.0, 0.02);
  const Scene mirror_scene = thrown(0.05, -30.0, -0.02);
  const Restitution original = result_of(impact::Run(scene));
  const auto disk = make_bodies(scene);
  Bodies bodies = *disk;
  bodies.all[0].lattice.points.col(0) *= -1.0;
  bodies.all[0].triangles = Triangles(bodies.disk());
  const auto mirrored = std::make_shared<const Composition>(
      compose(mirror_scene, std::make_shared<const Bodies>(std::move(bodies))));
  const Restitution image = result_of(impact::Run(mirror_scene, mirrored));
  EXPECT_NEAR(image.restitution, original.restitution, kRounding);
  EXPECT_NEAR(image.tangential_restitution, original.tangential_restitution, kRounding);
  EXPECT_NEAR(image.spin_after, -original.spin_after, kRounding);
  EXPECT_NEAR(image.tangential_velocity_after, -original.tangential_velocity_after, kRounding);
}

TEST(SpinningDisk, StartsAtItsVelocityAndSpin) {
  const Scene scene = thrown(0.1, 30.0, -0.2);
  const Composition composition = compose(scene);
  const BodyMotion motion = body_motion(composition.initial.position, composition.initial.velocity);
  EXPECT_NEAR(motion.velocity.x(), 0.05, 1e-15);
  EXPECT_NEAR(motion.velocity.y(), -0.1 * std::cos(M_PI / 6.0), 1e-15);
  EXPECT_NEAR(motion.spin(), -0.2, 1e-14);
}

/// Radii grow by ω² ρ R²/E to first order, ρ = M/(πR²) and E the lattice's, times a factor of order
/// one: at ω = 0.1 and 0.2 c/R in the ratio 4, but for higher orders of that 1 %.
TEST(SpinningDisk, IsStretchedByTheSquareOfItsSpin) {
  const auto growth = [](double spin) {
    const Scene scene = thrown(0.01, 0.0, spin);
    const auto bodies = make_bodies(scene);
    const PointArray shape = spinning_shape(scene, *bodies);
    return body_motion(shape, PointArray::Zero(200, 2)).moment_of_inertia /
               body_motion(bodies->disk().points, PointArray::Zero(200, 2)).moment_of_inertia -
           1.0;
  };
  EXPECT_GT(growth(0.1), 0.0);
  EXPECT_NEAR(growth(0.2) / growth(0.1), 4.0, 0.1);
}

/// In flight, before it comes near the wall, it turns as a rigid body: the energy of its inner
/// motion stays below 10⁻⁶ of what a disk that was set spinning as it lies would breathe with, half
/// the bonds' energy of the stretch.
TEST(SpinningDisk, DoesNotBreathe) {
  Scene scene = thrown(0.01, 0.0, 0.1);
  scene.impact.gap = 1.0;
  scene.numerics.step = 0.001;
  impact::Run run(scene);
  const double stretch = run.system().ledger().bonds;
  ASSERT_GT(stretch, 0.0);
  double most = 0.0;
  while (run.system().time() < 5.0) {
    run.advance();
    most = std::max(most, run.system().ledger().kinetic_internal);
  }
  EXPECT_LT(most, 1e-6 * stretch);
}

TEST(SpinningDisk, IsRefusedWhereItFliesApart) {
  Scene scene = thrown(0.01, 0.0, 1.0);
  scene.material.k_a = 1e-3;
  scene.material.k_b = 0.0;
  EXPECT_THROW(compose(scene), InputError);
}

/// Runs whose e is good at once while another number falls with h².
std::vector<double> estimates(double Restitution::*slow) {
  Scene scene = thrown(0.05, 30.0, 0.01);
  scene.numerics.step.reset();
  scene.numerics.error = 1e-4;
  ErrorControl control(scene, compose(scene));
  std::vector<double> steps;
  for (bool accepted = false; !accepted;) {
    FinishedImpact run;
    run.step = control.resolution().step;
    run.steps = 1000;
    for (const auto& [name, number] : impact_numbers<Restitution>()) run.measured.*number = 0.5;
    run.measured.velocity_before = -0.05;
    // Of odd sign from run to run, so that no order is seen.
    run.measured.*slow += (steps.size() % 2 == 0 ? 1.0 : -1.0) * 2.0 * run.step * run.step;
    steps.push_back(run.step);
    accepted = control.accepts(run);
  }
  return steps;
}

TEST(ObliqueImpact, IsGoodWhenSpinAndTangentialRestitutionAreToo) {
  EXPECT_EQ(estimates(&Restitution::tangential_energy).size(), 3U);
  EXPECT_GT(estimates(&Restitution::spin_after).size(), 3U);
  EXPECT_GT(estimates(&Restitution::tangential_restitution).size(), 3U);
}

Scene thrown_at_soft_wall(double angle) {
  Scene scene = thrown(0.1, angle, 0.0);
  scene.wall.kind = WallKind::kLattice;
  scene.wall.boundary = Boundary::kFixed;
  scene.wall.points = 1000;
  scene.wall.width = 8.0;
  scene.wall.height = 2.0;
  scene.wall.k_a = 0.05;
  return scene;
}

/// The points of a wall's surface in the order of x, by their rows in the arrays of all points.
std::vector<Eigen::Index> surface_of(const impact::Run& run) {
  const PointArray& wall = run.bodies()[1].lattice.points;
  const double top = wall.col(1).maxCoeff();
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < wall.rows(); ++i) {
    if (wall(i, 1) > top - 1e-12) rows.push_back(i);
  }
  std::sort(rows.begin(), rows.end(),
            [&](Eigen::Index a, Eigen::Index b) { return wall(a, 0) < wall(b, 0); });
  for (Eigen::Index& row : rows) row += run.lattice().points.rows();
  return rows;
}

/// What is found at one instant from the bonds of the surface straight below the points in contact.
struct UnderContact {
  double push = 0.0;    ///< along y, of every point
  double moment = 0.0;  ///< the same times the slopes of the bonds
  double chord = 0.0;   ///< its slope, of the points that are pushed with 1 % of the largest force
};

UnderContact under_contact(const impact::Run& run, const std::vector<Eigen::Index>& surface) {
  const PointArray& position = run.state().position;
  const Contact& contact = *run.system().field().contact();
  const auto slope = [&](std::size_t first, std::size_t last) {
    return (position(surface[last], 1) - position(surface[first], 1)) /
           (position(surface[last], 0) - position(surface[first], 0));
  };
  UnderContact found;
  std::size_t first = surface.size();
  std::size_t last = 0;
  for (const PointForce& point : contact.contacts(position, 0.0)) {
    std::size_t bond = 0;
    while (position(surface[bond + 1], 0) <= position(point.point, 0)) ++bond;
    found.push += point.force.y();
    found.moment += point.force.y() * slope(bond, bond + 1);
    if (point.force.matrix().norm() <= 0.01 * contact.largest_force()) continue;
    first = std::min(first, bond);
    last = std::max(last, bond + 1);
  }
  found.chord = first < last ? slope(first, last) : 0.0;
  return found;
}

/// Both slopes, found anew at every fourth step. The contact has no friction: the impulse is normal
/// to the bonds, which rise before the disk.
TEST(SurfaceSlope, IsThatOfTheChordAndTheImpulseIsNormalToTheBonds) {
  Scene scene = thrown_at_soft_wall(80.0);
  scene.output.period = 4.0 * *scene.numerics.step;
  impact::Run run(scene);
  const std::vector<Eigen::Index> surface = surface_of(run);
  ImpactAnalysis analysis;
  analysis.add(run.disk_state());
  UnderContact sum;
  while (!run.finished()) {
    run.advance();
    const UnderContact now = under_contact(run, surface);
    sum.push += now.push;
    sum.moment += now.moment;
    sum.chord += now.push * now.chord;
  }
  analysis.add(run.disk_state());
  EXPECT_GT(sum.chord, 0.0);
  // The least forces, 10⁻⁶ of M v c/R, do not count; the last look may come after fewer steps.
  EXPECT_NEAR(run.surface_slope(), sum.chord / sum.push, 1e-6);
  // The change of momentum against a sum over every fourth step.
  const double of_impulse = -analysis.restitution(true).impulse_ratio;
  EXPECT_NEAR(sum.moment / sum.push, of_impulse, 0.02 * of_impulse);
}

TEST(SurfaceSlope, IsNotMeasuredWhereNothingSlidesOrThePotentialPushes) {
  for (Scene scene : {thrown_at_soft_wall(0.0), thrown(0.1, 45.0, 0.0)}) {
    scene.impact.velocity = 0.01;
    impact::Run run(scene);
    while (!run.finished()) run.advance();
    EXPECT_TRUE(std::isnan(run.surface_slope()));
  }
}

/// With the disk's own constants it makes the steps of a wall that takes them over, bit for bit.
TEST(WallMaterial, OfTheDiskIsTheDisks) {
  for (const double eta : {0.0, 5.0}) {
    Scene scene = thrown(0.1, 45.0, 0.0);
    scene.material.eta = eta;
    scene.wall.kind = WallKind::kLattice;
    scene.wall.boundary = Boundary::kFixed;
    scene.wall.points = 240;
    const Restitution shared = result_of(impact::Run(scene));
    scene.wall.k_a = scene.material.k_a;
    scene.wall.k_b = scene.material.k_b;
    scene.wall.eta = eta;
    ASSERT_TRUE(compose(scene).field.bonds.has_two_laws());
    const Restitution own = result_of(impact::Run(scene));
    EXPECT_EQ(own.restitution, shared.restitution);
    EXPECT_EQ(own.spin_after, shared.spin_after);
  }
}

/// A wall a hundred times as soft gives way: the contact lasts longer, the force is smaller, and
/// the energy balance holds as with any other (energy_error, a failure of the run when it breaks).
TEST(WallMaterial, OfASoftWallMakesASoftContact) {
  Scene scene = thrown(0.01, 0.0, 0.0);
  scene.wall.kind = WallKind::kLattice;
  scene.wall.boundary = Boundary::kFixed;
  scene.wall.points = 240;
  const Restitution hard = result_of(impact::Run(scene));
  scene.wall.k_a = 0.01;
  const Restitution soft = result_of(impact::Run(scene));
  EXPECT_GT(soft.contact_duration, 2.0 * hard.contact_duration);
  EXPECT_LT(soft.peak_force, 0.5 * hard.peak_force);
}

/// Damping in the wall alone takes energy from an impact with an undamped disk.
TEST(WallMaterial, MayBeDampedByItself) {
  Scene scene = thrown(0.05, 0.0, 0.0);
  scene.wall.kind = WallKind::kLattice;
  scene.wall.boundary = Boundary::kFixed;
  scene.wall.points = 240;
  const double undamped = result_of(impact::Run(scene)).restitution;
  scene.wall.eta = 10.0;
  EXPECT_TRUE(scene.is_damped());
  EXPECT_LT(result_of(impact::Run(scene)).restitution, undamped - 0.01);
}

}  // namespace
}  // namespace impact
