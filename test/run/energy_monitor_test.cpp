#include "run/energy_monitor.hpp"

#include <gtest/gtest.h>

#include <string>

#include "mechanics/simulation.hpp"
#include "run/compose.hpp"

namespace impact {
namespace {

/// `believed` is the spectrum from which the simulation judges its step.
Simulation flying_disk(double step, const Spectrum& believed) {
  Scene scene;
  scene.disk.recipe.points = 50;
  Composition composition = compose(scene);
  // A pinch sets the fastest modes going.
  composition.initial.position.row(25) += 0.02;
  return Simulation(std::move(composition.field), std::move(composition.initial), believed, step);
}

TEST(EnergyMonitor, MeasuresTheLargestDeviation) {
  Simulation simulation = flying_disk(0.01, {1e3, 0.0});
  EnergyMonitor monitor(simulation.ledger());
  EXPECT_EQ(monitor.error(), 0.0);
  for (int k = 0; k < 100; ++k) {
    simulation.step();
    monitor.check(simulation);
  }
  EXPECT_GT(monitor.error(), 0.0);
  EXPECT_LT(monitor.error(), 0.01);
}

TEST(EnergyMonitor, StopsABlowUp) {
  Simulation simulation = flying_disk(1.0, {});
  EnergyMonitor monitor(simulation.ledger());
  try {
    for (int k = 0; k < 100; ++k) {
      simulation.step();
      monitor.check(simulation);
    }
    ADD_FAILURE() << "a step far beyond the limit went unnoticed";
  } catch (const RunFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("energy balance broke"), std::string::npos);
    EXPECT_LT(simulation.state().step, 10U);
  }
}

}  // namespace
}  // namespace impact
