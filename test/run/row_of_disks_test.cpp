#include "run/row_of_disks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mechanics/body_motion.hpp"
#include "mechanics/simulation.hpp"
#include "run/expected_time.hpp"
#include "run/run.hpp"
#include "theory/hertz.hpp"

namespace impact {
namespace {

constexpr int kPointsOfDisk = 150;

/// A disk thrown at a row of so many, with a step of its own.
Scene scene_of_row(int disks, double velocity) {
  Scene scene;
  scene.disk.recipe.points = kPointsOfDisk;
  scene.disk.orientation = Orientation::kBalanced;
  scene.wall.kind = WallKind::kDisk;
  scene.wall.disks = disks;
  scene.wall.mirrored = true;
  scene.impact.velocity = velocity;
  scene.numerics.step = 0.01;
  return scene;
}

void finish_row(impact::Run& run) {
  while (!run.finished()) run.advance();
}

Restitution row_result(impact::Run& run) {
  ImpactAnalysis analysis;
  run.show(analysis);
  finish_row(run);
  run.show(analysis);
  return analysis.restitution(true);
}

Restitution row_result(const Scene& scene) {
  impact::Run run(scene);
  return row_result(run);
}

BodyMotion motion_in_row(const State& state) { return body_motion(state.position, state.velocity); }

/// Velocities along y after the impact, over that of the impact, as seen by the row before it.
std::vector<double> velocities_after(const impact::Run& run, const Scene& scene) {
  const double others = static_cast<double>(scene.wall.disks);
  const double of_row = 1.0 / (1.0 + others);
  std::vector<double> velocities;
  for (std::size_t body = 0; body < run.bodies().size(); ++body) {
    const double v = motion_in_row(run.state_of(body)).velocity.y();
    velocities.push_back(of_row - v / scene.impact.normal_velocity());
  }
  return velocities;
}

TEST(RowOfDisks, StandsStraightAndJustOutOfContact) {
  Scene scene = scene_of_row(3, 0.02);
  scene.wall.mirrored = false;
  scene.wall.radius = 0.7;
  const impact::Run run(scene);
  ASSERT_EQ(run.bodies().size(), 4U);
  const double energy = impact_energy(scene, run.system().field().reduced_mass());
  double bottom = run.state_of(std::size_t{1}).position.col(1).minCoeff();
  EXPECT_EQ(run.state_of(std::size_t{1}).position.col(1).maxCoeff(), 0.0);
  for (std::size_t body = 2; body < 4; ++body) {
    const State state = run.state_of(body);
    EXPECT_EQ(state.position.rows(), 74);  // 0.49 times as many
    EXPECT_NEAR(motion_in_row(state).centre.x(), 0.0, 1e-12);
    const double gap = bottom - state.position.col(1).maxCoeff();
    // Ranges: ln of 10⁸ for the error and of some hundred points.
    EXPECT_GT(gap, 18.0 / scene.wall.a);
    EXPECT_LT(gap, 40.0 / scene.wall.a);
    bottom = state.position.col(1).minCoeff();
    EXPECT_TRUE((state.velocity.row(0) == run.state_of(std::size_t{1}).velocity.row(0)).all());
  }
  EXPECT_LT(run.system().field().contact()->potential_energy(run.state().position),
            negligible_fraction(scene) * energy);
  const auto& lattices = run.bodies();
  EXPECT_FALSE(lattices[2].lattice.bonds == lattices[1].lattice.bonds);
  EXPECT_FALSE(lattices[3].lattice.bonds == lattices[2].lattice.bonds);
}

TEST(RowOfDisks, IsMirroredFromDiskToDisk) {
  const auto bodies = make_bodies(scene_of_row(2, 0.02));
  PointArray twice = bodies->all[2].lattice.points - bodies->disk().points;
  // An image of an image is the lattice itself, elsewhere.
  EXPECT_LT((twice.rowwise() - twice.row(0)).abs().maxCoeff(), 1e-12);
  EXPECT_EQ(bodies->all[2].lattice.bonds, bodies->disk().bonds);
}

TEST(RowOfDisks, KeepsMomentumAngularMomentumAndEnergy) {
  Scene scene = scene_of_row(3, 0.1);
  scene.wall.mirrored = false;
  scene.wall.k_a = 0.5;
  scene.wall.a = 1000.0;
  scene.impact.angle = 20.0;
  scene.impact.spin = 0.05;
  scene.numerics.step = 0.004;
  impact::Run run(scene);
  const auto angular_momentum = [&] {
    const State& state = run.state();
    return (state.position.col(0) * state.velocity.col(1) -
            state.position.col(1) * state.velocity.col(0))
        .sum();
  };
  const double before = angular_momentum();
  finish_row(run);
  // Rounding of thousands of steps: 600 points of 0.1 c each, at up to 8 R.
  EXPECT_LT(run.state().velocity.colwise().sum().abs().maxCoeff(), 1e-11);
  EXPECT_NEAR(angular_momentum(), before, 1e-10);
  EXPECT_LT(run.energy_error(), 1e-4);
}

/// Equal disks far apart on the scale of their deformation pass their momentum on one after
/// another: each takes the part (1 + e)/2 of the one before, e that of a pair.
TEST(RowOfDisks, PassesItsMomentumOnDiskByDisk) {
  const double v = 0.005;
  const double e = row_result(scene_of_row(1, v)).restitution;
  impact::Run run(scene_of_row(3, v));
  const Restitution row = row_result(run);
  // A disk that was hit rings and spins, 10⁻³ of its energy, when it hits the next one.
  EXPECT_NEAR(row.momentum_passed_on, std::pow(0.5 * (1.0 + e), 3), 3e-3);
  EXPECT_NEAR(row.restitution_of_ends, row.momentum_passed_on, 3e-3);
  // Of the first disk alone against three: v′ = 0 for the row, v/4 as seen from the centre of mass.
  EXPECT_NEAR(row.restitution, 1.0 / 3.0, 3e-3);
  const std::vector<double> velocities = velocities_after(run, scene_of_row(3, v));
  EXPECT_NEAR(velocities[3], row.momentum_passed_on, 1e-12);
  EXPECT_NEAR(row.wall3_velocity_after, v * (0.25 - velocities[3]), 1e-15);
  EXPECT_NEAR(row.wall_velocity_after, v * (0.25 - velocities[1]), 1e-15);
}

/// Point masses, each pair of which feels Hertz contact of two disks in series with the repulsion
/// of one point each: a classic chain, solved by a Runge–Kutta method of its own.
class ChainOfPoints {
 public:
  ChainOfPoints(const Scene& scene, double gap) : scene_(scene), gap_(gap) {}

  /// Over the velocity of the impact.
  std::array<double, 4> velocities() const {
    constexpr double kStep = 0.02;  // R/c
    Phase phase{};
    for (std::size_t k = 0; k < 4; ++k) phase.place[k] = -gap_ * static_cast<double>(k);
    phase.velocity[0] = -scene_.impact.velocity;
    const double end = 4.0 * gap_ / scene_.impact.velocity + 40.0;
    for (double time = 0.0; time < end; time += kStep) {
      const Phase a = rate(phase);
      const Phase b = rate(sum(phase, 0.5 * kStep, a));
      const Phase c = rate(sum(phase, 0.5 * kStep, b));
      const Phase d = rate(sum(phase, kStep, c));
      for (const auto& [part, weight] : {std::pair(&a, 1.0), {&b, 2.0}, {&c, 2.0}, {&d, 1.0}}) {
        phase = sum(phase, weight * kStep / 6.0, *part);
      }
    }
    for (double& v : phase.velocity) v /= -scene_.impact.velocity;
    return phase.velocity;
  }

 private:
  struct Phase {
    std::array<double, 4> place;
    std::array<double, 4> velocity;
  };

  static Phase sum(Phase phase, double time, const Phase& rate) {
    for (std::size_t k = 0; k < 4; ++k) {
      phase.place[k] += time * rate.place[k];
      phase.velocity[k] += time * rate.velocity[k];
    }
    return phase;
  }

  Phase rate(const Phase& phase) const {
    Phase rate{phase.velocity, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      const double force = force_at(phase.place[k] - phase.place[k + 1]);
      rate.velocity[k] += force;
      rate.velocity[k + 1] -= force;
    }
    return rate;
  }

  /// Of outlines that would lie apart by this, R.
  double force_at(double apart) const {
    constexpr ElasticDisk kDisk{1.08, 0.275};
    const double v0 = 0.5 * scene_.wall.a / kPointsOfDisk;
    double low = std::log(1e-12);
    double high = std::log(0.1);
    for (int k = 0; k < 40; ++k) {
      const double middle = 0.5 * (low + high);
      const double force = std::exp(middle);
      // Each point and each image of it hold half of the force.
      const double gap = std::log(2.0 * scene_.wall.a * v0 / force) / scene_.wall.a;
      const double xi = inertial_load_compression(kDisk, force);
      (gap - 2.0 * xi > apart ? low : high) = middle;
    }
    return std::exp(low);
  }

  Scene scene_;
  double gap_;
};

/// Closer together, they push at the same time: the first comes back, the next follow the last.
TEST(RowOfDisks, DispersesAsAChainDoesWhereDisksNearlyTouch) {
  Scene scene = scene_of_row(3, 0.02);
  scene.wall.a = 3000.0;
  scene.numerics.step = 0.004;
  impact::Run run(scene);
  const double gap = run.state_of(std::size_t{1}).position.col(1).minCoeff() -
                     run.state_of(std::size_t{2}).position.col(1).maxCoeff();
  const Restitution row = row_result(run);
  const std::vector<double> found = velocities_after(run, scene);
  const std::array<double, 4> theory = ChainOfPoints(scene, gap).velocities();
  EXPECT_LT(theory[0], -0.01);
  EXPECT_LT(found[0], -0.01);
  EXPECT_LT(row.momentum_passed_on, 0.99);
  EXPECT_GT(row.momentum_passed_on, 0.9);
  // The chain knows no waves, which take a fifth of a contact to cross a disk: single lattices lie
  // about it by some 0.05, this one by 0.12.
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(found[k], theory[k], 0.15) << k;
}

/// A heavy row is set in motion slowly by a light disk: the run must not end before the second disk
/// has met the third.
TEST(RowOfDisks, IsFollowedUntilTheLastOneIsHit) {
  Scene scene = scene_of_row(2, 0.1);
  scene.wall.mirrored = false;
  scene.wall.radius = 3.0;
  const Restitution row = row_result(scene);
  // Without loss 2 m/(1 + m) of the momentum goes to the second disk, of the mass m = 9 M, and on
  // to the last one.
  EXPECT_LT(row.momentum_passed_on, 1.8);
  EXPECT_GT(row.momentum_passed_on, 1.4);
  EXPECT_LT(row.restitution_of_ends, 1.0);
}

/// Disks that part do so for good, however long they are followed; the others move slowly.
TEST(RowOfDisks, EndsWhenItsImpactIsOver) {
  Scene scene = scene_of_row(2, 0.1);
  scene.wall.mirrored = false;
  scene.impact.angle = 30.0;
  impact::Run run(scene);
  finish_row(run);
  EXPECT_FALSE(run.has_flag(Flag::kNotSeparated));
  const ForceField& field = run.system().field();
  Simulation on(field, run.state(),
                lattice_spectrum(run.lattice(), {1.0, 1e-3, 0.0}, 1.0 / kPointsOfDisk), 0.01);
  const double limit = 1e-2 * scene.numerics.error * impact_energy(scene, field.reduced_mass());
  for (int step = 0; step < 4000; ++step) {
    on.step();
    ASSERT_LT(on.field().disk_contacts->potential_energy(0, 2, on.state().position), limit);
  }
}

}  // namespace
}  // namespace impact
