#include "run/contact_recorder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "mechanics/simulation.hpp"
#include "run/compose.hpp"

namespace impact {
namespace {

TEST(ContactRecorder, ReportsSumUpToTheWholeCourse) {
  Scene scene;
  scene.disk.recipe.points = 50;
  scene.impact.velocity = 0.1;
  Composition composition = compose(scene);
  Simulation simulation(std::move(composition.field), std::move(composition.initial),
                        composition.rates.lattice, composition.resolution.step);
  constexpr double kContactForce = 1e-3;
  ContactRecorder recorder(simulation, kContactForce);
  const double momentum = simulation.state().velocity.col(1).mean();

  double impulse = 0.0;
  double peak = 0.0;
  std::size_t samples = 0;
  std::size_t listed = 0;
  for (int k = 1; k <= 600; ++k) {
    simulation.step();
    recorder.add_step(simulation);
    if (k % 7 != 0 && k != 600) continue;
    const ContactReport report = recorder.take(simulation).on_first;
    EXPECT_EQ(report.step, simulation.state().step);
    EXPECT_EQ(report.total.y(), simulation.field().wall->total_force().y());
    for (const PointForce& point : report.points) {
      EXPECT_GE(point.force.y(), kContactForce);
    }
    impulse += report.impulse;
    EXPECT_NEAR(impulse, simulation.state().velocity.col(1).mean() - momentum, 1e-13);
    peak = std::max(peak, report.peak_force);
    samples += report.samples.size();
    listed = std::max(listed, report.points.size());
  }
  EXPECT_EQ(samples, 601U);  // the start and every step
  EXPECT_GT(peak, 10 * kContactForce);
  EXPECT_GT(listed, 0U);
  EXPECT_LT(listed, 50U);
}

/// A contact starts where one point carries the load.
TEST(ContactRecorder, BeginsWithTheForceAtTheStart) {
  Scene scene;
  scene.kind = SceneKind::kContact;
  scene.disk.recipe.points = 50;
  scene.numerics.integrator = IntegratorKind::kVerlet;
  scene.material.eta = 10.0;
  Composition composition = compose(scene);
  const Simulation simulation(std::move(composition.field), std::move(composition.initial),
                              composition.rates.lattice, composition.resolution.step);
  ContactRecorder recorder(simulation, 0.0);
  const ContactReport report = recorder.take(simulation).on_first;
  EXPECT_GT(report.peak_force, 0.9 * scene.load.p);
  EXPECT_EQ(report.peak_force, report.total.y());
  EXPECT_EQ(report.impulse, 0.0);
}

/// What the disk feels, the elastic wall feels the other way.
TEST(ContactRecorder, ReportsTheReactionsOfAnElasticWall) {
  Scene scene;
  scene.disk.recipe.points = 50;
  scene.impact.velocity = 0.1;
  scene.wall.kind = WallKind::kLattice;
  scene.wall.points = 60;
  Composition composition = compose(scene);
  Simulation simulation(std::move(composition.field), std::move(composition.initial),
                        composition.rates.lattice, composition.resolution.step);
  ContactRecorder recorder(simulation, 0.0);
  std::size_t listed = 0;
  for (int k = 1; k <= 600; ++k) {
    simulation.step();
    recorder.add_step(simulation);
    const ContactReports reports = recorder.take(simulation);
    EXPECT_TRUE((reports.on_first.total == -reports.on(1).total).all());
    EXPECT_EQ(reports.on(1).step, simulation.state().step);
    Eigen::Array2d on_wall = Eigen::Array2d::Zero();
    for (const PointForce& point : reports.on(1).points) {
      EXPECT_GE(point.point, 0);
      EXPECT_LT(point.point, 60);
      on_wall += point.force;
    }
    // Rounding of forces of up to 1.
    EXPECT_LT((on_wall - reports.on(1).total).abs().maxCoeff(), 1e-13);
    listed = std::max(listed, reports.on(1).points.size());
  }
  EXPECT_GT(listed, 2U);
}

}  // namespace
}  // namespace impact
