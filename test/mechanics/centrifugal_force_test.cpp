#include "mechanics/centrifugal_force.hpp"

#include <gtest/gtest.h>

#include "test_lattices.hpp"

namespace impact {
namespace {

TEST(CentrifugalForce, DrawsPointsFromTheCentreOfMass) {
  const CentrifugalForce term(3.0, 0.5);
  PointArray position(2, 2);
  position << 4, 1, 2, -1;
  PointArray force = PointArray::Zero(2, 2);
  term.add_forces(position, force);
  PointArray expected(2, 2);
  expected << 4.5, 4.5, -4.5, -4.5;
  EXPECT_TRUE((force == expected).all());
}

/// Central differences, exact for a quadratic potential but for rounding: 10⁻¹⁶ of an energy of 1
/// over a step of 10⁻³.
TEST(CentrifugalForce, IsTheDerivativeOfItsEnergy) {
  const CentrifugalForce term(2.0, 0.25);
  const PointArray position = triangle().points;
  PointArray force = PointArray::Zero(3, 2);
  term.add_forces(position, force);
  const auto energy = [&](int point, int axis, double shift) {
    PointArray moved = position;
    moved(point, axis) += shift;
    EnergyLedger ledger;
    term.enter(moved, ledger);
    return ledger.load;
  };
  constexpr double kStep = 1e-3;
  for (const int point : {0, 1, 2}) {
    for (const int axis : {0, 1}) {
      const double slope =
          (energy(point, axis, kStep) - energy(point, axis, -kStep)) / (2.0 * kStep);
      EXPECT_NEAR(force(point, axis), -slope, 1e-12);
    }
  }
}

}  // namespace
}  // namespace impact
