// No heap use in the time loop. What GSL and SUNDIALS take within their own libraries is not
// counted.

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "counted_heap.hpp"
#include "mechanics/blanes_moan.hpp"
#include "mechanics/extrapolated_damping.hpp"
#include "mechanics/imex.hpp"
#include "mechanics/implicit_damping.hpp"
#include "mechanics/lane_bundle.hpp"
#include "mechanics/simulation.hpp"
#include "mechanics/takahashi_imada.hpp"
#include "mechanics/two_bodies.hpp"
#include "mechanics/velocity_verlet.hpp"
#include "reference/rk8pd.hpp"
#include "solvers/bdf.hpp"
#include "solvers/reduced_system.hpp"

namespace impact {
namespace {

/// Volatile, so that the compiler leaves no allocation out.
TEST(HeapUse, IsCounted) {
  EXPECT_EQ(allocations_of([] {
              int* volatile number = new int(1);
              delete number;
            }),
            1U);
  PointArray points;
  const double* volatile data = nullptr;
  EXPECT_EQ(allocations_of([&] {
              points.resize(10, 2);  // Eigen calls malloc()
              data = points.data();
            }),
            1U);
}

constexpr double kStep = 0.02;

/// A hexagon that slides on an elastic wall of which the lowest points are reset every other step.
TwoBodies on_elastic_wall(double eta) {
  TwoBodies bodies(1.4, {0.3, -0.1}, GapMeasure::kNormal, 10.0);
  bodies.field.bonds = BondForces(bodies.lattice, {1.0, 0.5, eta});
  bodies.field.velocity_reset.emplace(TwoBodies::bottom(), 2.0 * kStep);
  return bodies;
}

/// A patch pressed on the potential wall, its rotation held and one point on a rail.
TwoBodies on_potential_wall(double eta) {
  TwoBodies bodies = on_elastic_wall(eta);
  bodies.field.elastic_wall.reset();
  bodies.field.velocity_reset.reset();
  bodies.field.wall.emplace(10.0, 0.1);
  bodies.field.load.emplace(0.01, bodies.field.bonds.points());
  bodies.field.hold.emplace(bodies.lattice.points);
  bodies.field.supports.emplace(std::vector<std::int32_t>{3}, std::vector<std::int32_t>{});
  return bodies;
}

/// The same without the rail, for a method that takes bonds implicitly.
TwoBodies of_unstrained_bonds(double eta) {
  TwoBodies bodies = on_potential_wall(eta);
  bodies.field.supports.reset();
  bodies.field.unstrained = std::make_shared<const PointArray>(bodies.lattice.points);
  return bodies;
}

/// In 100 steps, after some that set things up.
std::uint64_t allocations_of_steps(const TwoBodies& bodies,
                                   std::unique_ptr<Integrator> integrator) {
  Simulation simulation(bodies.field, bodies.state,
                        lattice_spectrum(bodies.lattice, {1.0, 0.5, 0.1}, TwoBodies::kMass), kStep,
                        std::move(integrator));
  for (int k = 0; k < 10; ++k) simulation.step();
  const std::uint64_t found = allocations_of([&] {
    for (int k = 0; k < 100; ++k) simulation.step();
  });
  EXPECT_EQ(simulation.halvings(), 0);
  EXPECT_GT(simulation.field().contact()->largest_force(), 0.0);
  return found;
}

template <class I>
class HeapUseOf : public testing::Test {};
using OfFixedStep = testing::Types<VelocityVerlet, TakahashiImada, BlanesMoan, ImplicitDamping,
                                   ExtrapolatedDamping, Imex>;
TYPED_TEST_SUITE(HeapUseOf, OfFixedStep, );

TYPED_TEST(HeapUseOf, StepsIsNone) {
  if constexpr (std::is_same_v<TypeParam, Imex>) {
    EXPECT_EQ(allocations_of_steps(of_unstrained_bonds(0.0), std::make_unique<Imex>()), 0U);
    EXPECT_EQ(allocations_of_steps(of_unstrained_bonds(0.1), std::make_unique<Imex>()), 0U);
    return;
  }
  EXPECT_EQ(allocations_of_steps(on_elastic_wall(0.0), std::make_unique<TypeParam>()), 0U);
  EXPECT_EQ(allocations_of_steps(on_potential_wall(0.0), std::make_unique<TypeParam>()), 0U);
  if constexpr (!std::is_same_v<TypeParam, TakahashiImada> &&
                !std::is_same_v<TypeParam, BlanesMoan>) {
    EXPECT_EQ(allocations_of_steps(on_elastic_wall(0.1), std::make_unique<TypeParam>()), 0U);
    EXPECT_EQ(allocations_of_steps(on_potential_wall(0.1), std::make_unique<TypeParam>()), 0U);
  }
}

/// The same of a bundle of lanes.
template <template <class> class I>
std::uint64_t allocations_in_lanes(TwoBodies bodies) {
  bodies.field.load.reset();
  bodies.field.hold.reset();
  const Spectrum spectrum = lattice_spectrum(bodies.lattice, {1.0, 0.5, 0.1}, TwoBodies::kMass);
  LaneMotion first(bodies.field, bodies.state, spectrum, kStep, std::make_unique<I<ForceField>>());
  LaneMotion second(bodies.field, bodies.state, spectrum, kStep, std::make_unique<I<ForceField>>());
  EXPECT_TRUE(LaneField::knows(bodies.field));
  LaneBundle bundle(bodies.lattice, TwoBodies::kMass, LaneField::kind_of(bodies.field),
                    std::make_unique<I<LaneField>>(), true);
  bundle.add(first);
  bundle.add(second);
  for (int k = 0; k < 10; ++k) bundle.step();
  const std::uint64_t found = allocations_of([&] {
    for (int k = 0; k < 100; ++k) bundle.step();
  });
  EXPECT_EQ(second.steps(), 110U);
  return found;
}

TEST(HeapUse, OfStepsInLanesIsNone) {
  for (const double eta : {0.0, 0.1}) {
    TwoBodies bodies = on_potential_wall(eta);
    bodies.field.supports.reset();
    EXPECT_EQ(allocations_in_lanes<BasicVelocityVerlet>(bodies), 0U);
    if (eta == 0.0) {
      EXPECT_EQ(allocations_in_lanes<BasicTakahashiImada>(bodies), 0U);
    }
    EXPECT_EQ(allocations_in_lanes<BasicImplicitDamping>(bodies), 0U);
    EXPECT_EQ(allocations_in_lanes<BasicExtrapolatedDamping>(bodies), 0U);
  }
  EXPECT_EQ(allocations_in_lanes<BasicBlanesMoan>(on_elastic_wall(0.0)), 0U);
}

/// Evaluations and, of Bdf, solutions; it does take memory for a new matrix and its factors.
TEST(HeapUse, OfEvaluationsIsNone) {
  TwoBodies bodies = on_potential_wall(0.1);
  FirstOrderForm form(bodies.lattice.points.rows());
  Eigen::VectorXd y(form.size());
  Eigen::VectorXd rate(form.size());
  form.pack(bodies.state, y.data());
  form.evaluate(bodies.field, y.data(), rate.data());  // the first one sets things up
  EXPECT_EQ(allocations_of([&] { form.evaluate(bodies.field, y.data(), rate.data()); }), 0U);
}

TEST(HeapUse, OfSolutionsIsNone) {
  const TwoBodies bodies = on_potential_wall(0.1);
  ReducedSystem system(bodies.field);
  system.set_stiffness(bodies.field, bodies.state.position);
  ASSERT_TRUE(system.factorise(0.1));
  Eigen::VectorXd r = Eigen::VectorXd::Ones(4 * bodies.lattice.points.rows() + 2);
  EXPECT_EQ(allocations_of([&] { system.solve(r.data()); }), 0U);
}

TEST(HeapUse, OfStepsOfRk8pdIsNone) {
  EXPECT_EQ(
      allocations_of_steps(on_potential_wall(0.1), std::make_unique<Rk8pd>(1e-8, Scales{1.0, 1.0})),
      0U);
}

}  // namespace
}  // namespace impact
