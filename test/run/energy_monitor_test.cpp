#include "run/energy_monitor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

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
  const double start = simulation.ledger().total();
  double deviation = 0.0;
  double energy = start;  // all of it kinetic, or in bonds and the wall
  for (int k = 0; k < 100; ++k) {
    simulation.step();
    monitor.check(simulation);
    deviation = std::max(deviation, std::abs(simulation.ledger().total() - start));
    energy = std::max(energy, simulation.ledger().total());
  }
  EXPECT_GT(monitor.error(), 0.0);
  EXPECT_LT(monitor.error(), 0.01);
  EXPECT_DOUBLE_EQ(monitor.error(), deviation / energy);
}

/// `start` but with a total that the present one deviates from by this much.
EnergyLedger off_by(double deviation, EnergyLedger start, const System& system) {
  start.load = 0.0;  // not an energy of the bodies
  start.load = system.ledger().total() - deviation - start.total();
  return start;
}

/// Where nearly all energy was dissipated, little of it is left in the bodies.
TEST(EnergyMonitor, AllowsADeviationByWhatIsLost) {
  Scene scene;
  scene.disk.recipe.points = 50;
  scene.material.eta = 10.0;
  Composition composition = compose(scene);
  composition.initial.velocity.setZero();
  composition.initial.velocity.row(25) += 0.02;
  Simulation simulation(std::move(composition.field), std::move(composition.initial),
                        composition.rates.lattice, composition.resolution.step);
  while (simulation.time() < 20.0) simulation.step();
  const double lost = simulation.ledger().dissipated;
  ASSERT_GT(lost, 4.0 * (simulation.ledger().kinetic() + simulation.ledger().bonds));
  EnergyMonitor allowing(off_by(0.9 * lost, {}, simulation));
  EXPECT_NO_THROW(allowing.check(simulation));
  EnergyMonitor other(off_by(1.1 * lost, {}, simulation));
  EXPECT_THROW(other.check(simulation), RunFailure);
}

/// Each energy of the bodies by itself allows a deviation as large.
TEST(EnergyMonitor, MeasuresByEveryEnergyOfTheBodies) {
  const Simulation simulation = flying_disk(0.01, {1e3, 0.0});
  const double energy = 2.0 * simulation.ledger().total();
  for (double EnergyLedger::*const term : {&EnergyLedger::kinetic_internal, &EnergyLedger::bonds,
                                           &EnergyLedger::wall, &EnergyLedger::wall_lattice}) {
    EnergyLedger start;
    start.*term = energy;
    EnergyMonitor allowing(off_by(0.9 * energy, start, simulation));
    EXPECT_NO_THROW(allowing.check(simulation));
    EnergyMonitor other(off_by(1.1 * energy, start, simulation));
    EXPECT_THROW(other.check(simulation), RunFailure);
  }
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
