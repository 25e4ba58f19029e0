#include "reduced/modal_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "mechanics/imex.hpp"
#include "mechanics/simulation.hpp"
#include "mechanics/spectrum.hpp"
#include "small_disk.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

constexpr double kSlowSpeed = 3e-3;
constexpr double kError = 1e-6;  // of e, wanted
constexpr double kFarAbove = 100.0;

/// A disk with damping, and its modes.
struct DampedDisk : SmallDisk {
  explicit DampedDisk(double eta, int points = 150) : SmallDisk(points) {
    field.bonds = BondForces(lattice, {1.0, 1e-3, eta / points});
    field.unstrained = std::make_shared<const PointArray>(lattice.points);
    modes = std::make_shared<const BulkModes>(bulk_modes(lattice, *compliance, kA));
  }
  ModalSystem system() const { return {modes, field.bonds.law(), *field.wall, nullptr}; }
  ModalCorrection correction(const State& start, double error = kError) const {
    return modal_correction(system(), field, Triangles(lattice), start, *compliance, error);
  }
  ModalMotion motion(double step) const {
    const State start = above(0.12, kSlowSpeed);
    return {field, start, modes, correction(start), 0.0, step};
  }

  std::shared_ptr<const BulkModes> modes;
};

/// Until the disk has left the wall.
template <class Moving>
double velocity_after(Moving& motion) {
  const auto velocity = [&] { return motion.state().velocity.col(1).mean(); };
  while (velocity() < 0.0 || motion.field().wall->total_force().y() > 1e-16) motion.step();
  return velocity();
}

double energy(const ModalDynamics& dynamics) {
  const ModalState& state = dynamics.state();
  const Eigen::VectorXd stiffness = dynamics.system().law.k_a * dynamics.system().modes->stiffness;
  return dynamics.kinetic_energy() +
         0.5 * stiffness.dot(state.amplitudes.cwiseProduct(state.amplitudes));
}

/// All modes at once, far from the wall: the implicit mid-step rule keeps the energy but for what
/// the damping takes, to rounding.
TEST(ModalDynamics, LosesWhatTheDampingTakes) {
  const DampedDisk disk(10.0);
  ModalState start = modal_state(*disk.modes, disk.above(kFarAbove, 0.0));
  start.amplitudes.setConstant(1e-3);
  start.amplitudes(0) = 0.0;
  start.rates.setConstant(2e-3);
  ModalDynamics dynamics(disk.system(), start, 0.3);
  const double before = energy(dynamics);
  double lost = 0.0;
  for (int k = 0; k < 20; ++k) {
    const double taken = dynamics.step();
    EXPECT_GE(taken, 0.0);
    lost += taken;
  }
  EXPECT_NEAR(energy(dynamics) + lost, before, 1e-11 * before);
  EXPECT_GT(lost, 0.5 * before);
}

/// cos ωt, a quarter of the error with half the step.
TEST(ModalDynamics, SwingsAModeToTheSecondOrder) {
  const DampedDisk disk(0.0);
  ModalState start = modal_state(*disk.modes, disk.above(kFarAbove, 0.0));
  start.amplitudes(2) = 1e-3;
  const double frequency = std::sqrt(disk.modes->stiffness(2));
  const auto error = [&](int steps) {
    ModalDynamics dynamics(disk.system(), start, 1.0 / steps);
    for (int k = 0; k < steps; ++k) dynamics.step();
    return dynamics.state().amplitudes(2) - 1e-3 * std::cos(frequency);
  };
  EXPECT_NEAR(error(40) / error(80), 4.0, 0.05);
}

/// Steps hold as long as h² times the greatest eigenvalue of what the wall adds, H μ⁻¹ Hᵀ a f + the
/// same of the centre of mass, is below 4. Long steps lower it: their modes are heavier.
TEST(ModalDynamics, BoundsWhatTheWallAddsToFrequencies) {
  const DampedDisk disk(10.0);
  const BulkModes& modes = *disk.modes;
  const Eigen::Index n = modes.arm.rows();
  double before = std::numeric_limits<double>::infinity();
  for (const double step : {0.0, 0.1, 0.5, 3.0}) {
    const ModalDynamics dynamics(disk.system(), modal_state(modes, disk.above(0.0, kSlowSpeed)),
                                 step);
    Eigen::MatrixXd heights = modes.shapes.bottomRows(n)(modes.points, Eigen::all);
    heights.col(0) = modes.arm(modes.points, 0).matrix() / std::sqrt(modes.inertia);
    const Eigen::ArrayXd root = (disk.field.wall->a() * dynamics.contact_forces()).array().sqrt();
    const Eigen::ArrayXd inertia = 1.0 + step * step * modes.stiffness.array() / 12.0;
    Eigen::MatrixXd added =
        (heights * inertia.inverse().matrix().asDiagonal() * heights.transpose()).array() + 1.0;
    added = root.matrix().asDiagonal() * added * root.matrix().asDiagonal();
    const double greatest =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(added).eigenvalues().maxCoeff();
    EXPECT_GE(dynamics.contact_rate(), greatest * (1.0 - 1e-12)) << step;
    EXPECT_LE(dynamics.contact_rate(), 3.0 * greatest) << step;
    EXPECT_LT(dynamics.contact_rate(), before) << step;
    before = dynamics.contact_rate();
  }
}

/// As ReducedMotion has it.
TEST(ModalDynamics, OfAStiffBodyHasTheRigidLimit) {
  PointArray points(3, 2);
  points << 0.0, 0.0, 1.2, 0.6, -0.4, 0.9;
  const Lattice lattice = plain_lattice(points, {{0, 1}, {0, 2}, {1, 2}});
  const PointArray arm = about_the_centre(points);
  const double x = arm(0, 0);
  const double k_squared = arm.square().sum() / 3.0;
  constexpr double kShort = 3e4;
  Compliance compliance(lattice);
  const auto modes = std::make_shared<const BulkModes>(bulk_modes(lattice, compliance, kShort));
  State start{0.0, 0, points, PointArray::Zero(3, 2)};
  start.position.col(1) += 2e-3;
  start.velocity.col(1) = -kSlowSpeed;
  ModalDynamics dynamics({modes, {1e9, 0.0, 0.0}, {kShort, 1e-4}, nullptr},
                         modal_state(*modes, start), 0.05 / (kShort * kSlowSpeed));
  while (dynamics.time() < 4.0) dynamics.step();
  const double e = (k_squared - x * x) / (k_squared + x * x);
  EXPECT_NEAR(dynamics.state().velocity / kSlowSpeed, e, 1e-3);
  EXPECT_NEAR(dynamics.spin(), x * (1.0 + e) * kSlowSpeed / k_squared, 1e-3 * kSlowSpeed);
}

/// Parabolas; nothing more than two intervals beside them.
TEST(ForceCourse, IsInterpolated) {
  ForceCourse course{2.0, 0.5, Eigen::MatrixXd(1, 6)};
  const auto parabola = [](double t) { return 1.0 + t * (3.0 - t); };
  for (int k = 0; k < 6; ++k) course.forces(0, k) = parabola(2.0 + 0.5 * k);
  const auto at = [&](double time) {
    Eigen::VectorXd force = Eigen::VectorXd::Constant(1, 7.0);
    course.add_to(force, time);
    return force(0) - 7.0;
  };
  for (const double time : {2.5, 2.6, 3.3, 4.0}) EXPECT_NEAR(at(time), parabola(time), 1e-13);
  EXPECT_EQ(at(0.9), 0.0);
  EXPECT_EQ(at(5.6), 0.0);
}

/// Of errors that fall as the square of the step.
template <class VelocityInStepsOf>
double limit(double step, const VelocityInStepsOf& velocity_in_steps_of) {
  return (4.0 * velocity_in_steps_of(0.5 * step) - velocity_in_steps_of(step)) / 3.0;
}

/// A patch so small that its modes are all it has: the whole nonlinear lattice.
TEST(ModalMotion, IsExactWhereTheModesAreAll) {
  const Lattice lattice = triangular_patch(3);
  const auto compliance = std::make_shared<Compliance>(lattice);
  const auto modes = std::make_shared<const BulkModes>(bulk_modes(lattice, *compliance, kA));
  ASSERT_EQ(modes->stiffness.size(), 2 * 9 - 2);
  ForceField field{BondForces(lattice, {1.0, 0.0, 0.3}), 1.0 / 9.0};
  field.wall.emplace(kA, kA / 9.0);
  field.unstrained = std::make_shared<const PointArray>(lattice.points);
  State start{0.0, 0, lattice.points, PointArray::Zero(9, 2)};
  start.position.col(1) += 0.12;
  start.velocity.col(1) = -kSlowSpeed;
  const double step = 0.05 / (kA * kSlowSpeed);
  const ModalCorrection correction =
      modal_correction({modes, field.bonds.law(), *field.wall, nullptr}, field, Triangles(lattice),
                       start, *compliance, 1e-9);
  EXPECT_LT(correction.left_out.restitution, 1e-4);
  const double by_modes = limit(step, [&](double h) {
    ModalMotion modal(field, start, modes, correction, 0.0, h);
    return velocity_after(modal);
  });
  const double of_all = limit(step, [&](double h) {
    Simulation all(field, start, lattice_spectrum(lattice, field.bonds.law(), 1.0 / 9.0), h,
                   std::make_unique<Imex>());
    return velocity_after(all);
  });
  constexpr double kOfSteps = 1e-7;  // of e: the next power of the step
  EXPECT_NEAR(by_modes, of_all, (correction.left_out.restitution + kOfSteps) * of_all);
  EXPECT_LT(of_all, 0.99 * kSlowSpeed);
}

/// Against all points, limits of two steps each: no more than is said, and much less than the
/// linear bulk leaves out.
TEST(ModalMotion, LeavesOutWhatItSays) {
  for (const double eta : {0.3, 10.0, 100.0}) {
    const DampedDisk disk(eta);
    const double step = 0.05 / (kA * kSlowSpeed);
    const State start = disk.above(0.12, kSlowSpeed);
    const double by_modes = limit(step, [&](double h) {
      ModalMotion modal = disk.motion(h);
      return velocity_after(modal);
    });
    const double by_linear_modes = limit(step, [&](double h) {
      ModalMotion linear(disk.field, start, disk.modes, {nullptr, {}}, 0.0, h);
      return velocity_after(linear);
    });
    const double of_all = limit(step, [&](double h) {
      Simulation all(disk.field, start,
                     lattice_spectrum(disk.lattice, disk.field.bonds.law(), 1.0 / 150), h,
                     std::make_unique<Imex>());
      return velocity_after(all);
    });
    const ModelError left_out = disk.motion(step).model_error();
    const double error = std::abs(by_modes / of_all - 1.0);
    EXPECT_LT(error, left_out.restitution) << eta;
    EXPECT_LT(left_out.restitution, 3e-4) << eta;
    EXPECT_LT(error, 0.2 * std::abs(by_linear_modes / of_all - 1.0)) << eta;
  }
}

/// The states that it gives have its height, spin and energy.
TEST(ModalMotion, RecoversAllPoints) {
  const DampedDisk disk(1.0);
  ModalMotion motion = disk.motion(0.1);
  const double before = motion.ledger().total();
  while (motion.dynamics().state().velocity < 0.0) motion.step();
  for (int k = 0; k < 5; ++k) motion.step();
  const BodyMotion whole = body_motion(motion.state().position, motion.state().velocity);
  EXPECT_NEAR(whole.centre.y(), motion.dynamics().state().height, 1e-12);
  EXPECT_NEAR(whole.velocity.y(), motion.dynamics().state().velocity, 1e-12);
  EXPECT_NEAR(whole.spin(), motion.dynamics().spin(), 1e-2 * kSlowSpeed);
  EXPECT_NEAR(motion.kinetic_energy(), motion.ledger().kinetic(), 1e-2 * before);
  EXPECT_NEAR(motion.ledger().total(), before, 1e-3 * before);
  EXPECT_GT(motion.ledger().bonds, 0.05 * before);
}

/// A start that is higher by some way makes the same run later.
TEST(ModalMotion, TakesItsCorrectionLater) {
  const DampedDisk disk(30.0);
  const State start = disk.above(0.12, kSlowSpeed);
  const ModalCorrection correction = disk.correction(start);
  const double step = 0.1;
  const State higher = disk.above(0.12 + 20 * step * kSlowSpeed, kSlowSpeed);
  ModalMotion motion(disk.field, start, disk.modes, correction, 0.0, step);
  ModalMotion later(disk.field, higher, disk.modes, correction, 20 * step, step);
  const double after = velocity_after(motion);
  EXPECT_NEAR(velocity_after(later), after, 1e-7 * after);
}

/// With a wall too stiff for the step.
TEST(ModalMotion, HalvesItsStep) {
  const DampedDisk disk(30.0);
  ModalMotion motion = disk.motion(1.5);
  velocity_after(motion);
  EXPECT_GT(motion.halvings(), 0);
  EXPECT_LE(motion.stiffest_contact() * motion.step_size() * motion.step_size(), 16.0);
}

/// A body that is pressed in too far to converge.
TEST(ModalCorrection, SaysWhereItDoesNotConverge) {
  const DampedDisk disk(1.0, 60);
  const ModalCorrection slow = disk.correction(disk.above(0.12, 1e-3));
  EXPECT_LT(slow.left_out.restitution, 1e-5);
  const ModalCorrection fast = disk.correction(disk.above(0.12, 0.3));
  EXPECT_GT(fast.left_out.restitution, 0.1);
}

}  // namespace
}  // namespace impact
