#include "mechanics/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/body_motion.hpp"
#include "test_lattices.hpp"
#include "two_bodies.hpp"

namespace impact {
namespace {

constexpr int kSide = 5;
constexpr double kPatchMass = 1.0 / (kSide * kSide);

/// A triangular patch above the wall, falling and spinning.
State falling_patch() {
  State state;
  state.position = triangular_patch(kSide).points;
  state.position.col(1) += 0.2;
  state.velocity.resizeLike(state.position);
  state.velocity.col(0) = -0.02 * state.position.col(1);
  state.velocity.col(1) = 0.02 * state.position.col(0) - 0.1;
  return state;
}

Simulation patch_simulation(double step, double eta, double a = 20.0) {
  const Lattice lattice = triangular_patch(kSide);
  const BondLaw law{1.0, 0.5, eta};
  ForceField field{BondForces(lattice, law), kPatchMass};
  field.wall.emplace(a, 1.0);
  return Simulation(std::move(field), falling_patch(), lattice_spectrum(lattice, law, kPatchMass),
                    step);
}

void run_until(Simulation& simulation, double time) {
  while (simulation.state().time < time - 0.5 * simulation.step_size()) simulation.step();
}

class Damping : public testing::TestWithParam<double> {};

/// Second order through contact with the wall, damped and undamped.
TEST_P(Damping, OrderIsTwo) {
  const auto position = [&](double step) {
    Simulation simulation = patch_simulation(step, GetParam());
    run_until(simulation, 4.0);
    return simulation.state().position;
  };
  const PointArray reference = position(1e-4);
  const double coarse = (position(8e-3) - reference).abs().maxCoeff();
  const double fine = (position(4e-3) - reference).abs().maxCoeff();
  // The reference errs by (1/40)² of the fine error, terms of order h⁴ add a few per cent.
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1);
}

/// The ledger is constant to second order.
TEST_P(Damping, LedgerClosesToSecondOrder) {
  const auto defect = [&](double step) {
    Simulation simulation = patch_simulation(step, GetParam());
    const double start = simulation.ledger().total();
    double largest = 0.0;
    while (simulation.state().time < 4.0) {
      simulation.step();
      largest = std::max(largest, std::abs(simulation.ledger().total() - start));
    }
    return largest;
  };
  EXPECT_NEAR(std::log2(defect(8e-3) / defect(4e-3)), 2.0, 0.15);
}

/// The change of momentum is the impulse of the wall: Verlet's own sum of h F is exact up to the
/// halves at both ends, which the trapezoidal rule has too.
TEST_P(Damping, MomentumChangesByTheImpulseOfTheWall) {
  Simulation simulation = patch_simulation(5e-3, GetParam());
  const auto momentum = [&] { return simulation.state().velocity.col(1).mean(); };
  const double start = momentum();
  double impulse = 0.0;
  double last_force = simulation.field().wall->total_force().y();
  while (simulation.state().time < 4.0) {
    simulation.step();
    const double force = simulation.field().wall->total_force().y();
    impulse += 0.5 * simulation.step_size() * (last_force + force);
    last_force = force;
  }
  EXPECT_GT(impulse, 0.05);
  EXPECT_NEAR(momentum() - start, impulse, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Eta, Damping, testing::Values(0.0, 0.02));

/// A free undamped patch keeps its angular momentum to rounding; a damped one loses it.
TEST(Simulation, AngularMomentumOfAFreePatch) {
  const Lattice lattice = triangular_patch(kSide);
  for (const double eta : {0.0, 0.02}) {
    const BondLaw law{1.0, 0.5, eta};
    Simulation simulation(ForceField{BondForces(lattice, law), kPatchMass}, falling_patch(),
                          lattice_spectrum(lattice, law, kPatchMass), 0.005);
    const auto angular_momentum = [&] {
      return body_motion(simulation.state().position, simulation.state().velocity).angular_momentum;
    };
    const double start = angular_momentum();
    run_until(simulation, 5.0);
    if (eta == 0.0) {
      EXPECT_NEAR(angular_momentum() / start, 1.0, 1e-12);
    } else {
      EXPECT_LT(angular_momentum(), 0.99 * start);
    }
  }
}

/// A wall that grows stiffer than the lattice: the step is halved as it must be, time goes on
/// evenly and the energy holds.
TEST(Simulation, HalvesTheStepWhenTheWallGrowsTooStiff) {
  Simulation simulation = patch_simulation(0.1, 0.0, 1000.0);
  const double start = simulation.ledger().total();
  double last_time = 0.0;
  double impulse = 0.0;
  while (simulation.state().time < 4.0) {
    simulation.step();
    EXPECT_NEAR(simulation.state().time - last_time, simulation.step_size(), 1e-12);
    last_time = simulation.state().time;
    impulse += simulation.step_size() * simulation.field().wall->total_force().y();
  }
  EXPECT_GT(impulse, 0.05);
  EXPECT_GT(simulation.halvings(), 0);
  // A step grows up to half the stability limit of the wall, where energy errs by per cents at
  // most; without the halving this patch gains a factor of thousands.
  EXPECT_NEAR(simulation.ledger().total() / start, 1.0, 0.02);
}

TEST(Simulation, StaticForceLeavesOutTheDamping) {
  Simulation simulation = patch_simulation(5e-3, 0.02);
  // Far from the wall and unstrained, though in motion.
  EXPECT_LT(simulation.largest_static_force(), 1.001 * simulation.field().wall->force_at(0.2));
}

/// Total momentum and angular momentum about the origin of all points, M c and M c R.
Eigen::Array3d momenta(const State& state) {
  const auto& r = state.position;
  const auto& v = state.velocity;
  return TwoBodies::kMass * Eigen::Array3d(v.col(0).sum(), v.col(1).sum(),
                                           (r.col(0) * v.col(1) - r.col(1) * v.col(0)).sum());
}

/// Nothing acts from outside, and the contact balances force and torque, hops or not.
TEST(TwoBodies, KeepTheirMomenta) {
  for (const double sideways : {0.0, 0.3}) {
    Simulation simulation = TwoBodies(2.4, {sideways, -0.1}).simulation(0.01);
    const Eigen::Array3d start = momenta(simulation.state());
    double impulse = 0.0;
    while (simulation.state().time < 12.0) {
      simulation.step();
      impulse += simulation.step_size() * simulation.field().elastic_wall->total_force().y();
      // Rounding of 39 points over 1200 steps.
      EXPECT_LT((momenta(simulation.state()) - start).abs().maxCoeff(), 1e-13);
    }
    EXPECT_GT(impulse, 0.1);
  }
}

/// The limit of the lattice's highest frequency with that of two points which push each other apart
/// added, each of half the mass: 2/√(ω² + 2 · 1.5 a F/m), where the force F grows by e^(a v h)
/// within the step.
TEST(TwoBodies, HalveTheStepAtTheLimitOfBothEnds) {
  constexpr double kA = 10.0;
  constexpr double kSpeed = 0.1;
  const TwoBodies bodies(2.4, {0.0, -kSpeed}, GapMeasure::kNormal, kA);
  const double omega_squared =
      lattice_spectrum(bodies.lattice, {1.0, 0.5, 0.0}, TwoBodies::kMass).omega_squared;
  const double force = bodies.field.elastic_wall->largest_force();
  const auto limit = [&](double step) {
    const double stiffness = kA * force * std::exp(kA * kSpeed * step);
    return 2.0 / std::sqrt(omega_squared +
                           2.0 * Motion::wall_margin(false) * stiffness / TwoBodies::kMass);
  };
  double longest = 0.0;
  for (double part = 1.0; part > 1e-9; part /= 2.0) {
    if (longest + part <= limit(longest + part)) longest += part;
  }
  ASSERT_LT(longest, 0.99 * 2.0 / std::sqrt(omega_squared));
  for (const double share : {0.999, 1.001}) {
    Simulation simulation = bodies.simulation(share * longest);
    simulation.step();
    EXPECT_EQ(simulation.halvings(), share > 1.0 ? 1 : 0);
    const double first = share * longest;
    const double stiffest = 2.0 * Motion::wall_margin(false) * kA * force *
                            std::exp(kA * kSpeed * first) / TwoBodies::kMass;
    EXPECT_NEAR(simulation.stiffest_contact() / stiffest, 1.0, 1e-12);
  }
}

/// Of the points of both bodies that move towards each other fastest.
double approach(const Simulation& simulation) {
  const auto vertical = [&](const Body& body) {
    return body.rows_of(simulation.state().velocity).col(1).eval();
  };
  const ForceField& field = simulation.field();
  return std::max(0.0, -vertical(field.first_body()).minCoeff()) +
         std::max(0.0, vertical(field.others.front()).maxCoeff());
}

/// Whether the step was halved or not, the stiffness is that of steps as long as the first.
TEST(TwoBodies, TellTheGreatestStiffnessForTheFirstStep) {
  const TwoBodies bodies(2.4, {0.0, -0.1}, GapMeasure::kNormal, 40.0);
  Simulation halved = bodies.simulation(0.5);
  double stiffest = 0.0;
  while (halved.state().time < 3.0) {
    const double force = halved.field().contact()->largest_force();
    const double rate = 2.0 * Motion::wall_margin(false) * 40.0 * force *
                        std::exp(40.0 * approach(halved) * 0.5) / TwoBodies::kMass;
    stiffest = std::max(stiffest, rate);
    halved.step();
  }
  EXPECT_GT(halved.halvings(), 0);
  EXPECT_NEAR(halved.stiffest_contact() / stiffest, 1.0, 1e-12);
}

/// A body at rest that is hit from below is as one that falls: the step is halved at the same time,
/// and the motion differs by the frame's alone.
TEST(TwoBodies, DoNotCareAboutTheFrame) {
  constexpr double kSpeed = 0.1;
  const TwoBodies falling(2.4, {0.0, -kSpeed}, GapMeasure::kNormal, 4000.0);
  TwoBodies rising = falling;
  rising.state.velocity.col(1) += kSpeed;
  Simulation first = falling.simulation(0.1);
  Simulation second = rising.simulation(0.1);
  while (first.state().time < 6.0) {
    first.step();
    second.step();
    ASSERT_EQ(first.step_size(), second.step_size()) << first.state().time;
  }
  EXPECT_GT(first.halvings(), 0);
  PointArray difference = second.state().position - first.state().position;
  difference.col(1) -= kSpeed * first.state().time;
  // Rounding of positions of order 1, in gaps 4000 times as large.
  EXPECT_LT(difference.abs().maxCoeff(), 1e-9);
}

/// Largest deviation of a sum of energies from its value at the start.
template <class Energy>
double largest_deviation(Simulation& simulation, double time, const Energy& energy) {
  const double start = energy(simulation.ledger());
  double largest = 0.0;
  while (simulation.state().time < time) {
    simulation.step();
    largest = std::max(largest, std::abs(energy(simulation.ledger()) - start));
  }
  return largest;
}

/// A contact that stays on its bond; what comes into reach at the threshold is e⁻⁴⁰ of the wall's
/// energy.
TEST(TwoBodies, LedgerClosesToSecondOrderWithoutHops) {
  for (const GapMeasure measure : {GapMeasure::kNormal, GapMeasure::kVertical}) {
    const auto defect = [&](double step) {
      Simulation simulation = TwoBodies(2.4, {0.01, -0.1}, measure).simulation(step);
      const double largest = largest_deviation(
          simulation, 10.0, [](const EnergyLedger& ledger) { return ledger.total(); });
      EXPECT_LT(simulation.ledger().hops_size, 1e-12);
      EXPECT_GT(simulation.ledger().wall_lattice, 1e-4);
      return largest;
    };
    EXPECT_NEAR(std::log2(defect(8e-3) / defect(4e-3)), 2.0, 0.15);
  }
}

/// A hexagon thrown aslant, whose points pass from bond to bond under load. A hop happens within a
/// step, but is found at its end: where the force jumps by ΔF, the trapezoidal rule misses up to
/// h |ΔF · v|/2. So the ledger closes to first order, and without the hops it does not close.
TEST(TwoBodies, LedgerClosesToFirstOrderWhereHopsAreCounted) {
  const auto defect = [](double step, bool count_hops) {
    Simulation simulation = TwoBodies(1.4, {0.3, -0.5}, GapMeasure::kNormal, 10.0).simulation(step);
    const double largest =
        largest_deviation(simulation, 14.0, [count_hops](const EnergyLedger& ledger) {
          return ledger.total() - (count_hops ? 0.0 : ledger.hops);
        });
    EXPECT_GT(simulation.ledger().hops_size, 4e-4);
    return largest;
  };
  const double coarse = defect(1e-3, true);
  const double fine = defect(5e-4, true);
  // Other hops fall into other places of their steps: that moves the sum by a few per cent.
  EXPECT_NEAR(coarse / fine, 2.0, 0.2);
  EXPECT_GT(defect(5e-4, false), 20.0 * fine);
}

}  // namespace
}  // namespace impact
