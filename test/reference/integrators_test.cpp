// What holds for every integrator.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <type_traits>
#include <vector>

#include "mechanics/blanes_moan.hpp"
#include "mechanics/extrapolated_damping.hpp"
#include "mechanics/imex.hpp"
#include "mechanics/implicit_damping.hpp"
#include "mechanics/spectrum.hpp"
#include "mechanics/takahashi_imada.hpp"
#include "mechanics/velocity_verlet.hpp"
#include "reference/rk8pd.hpp"
#include "solvers/bdf.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

template <class I>
constexpr bool kIsAdaptive = std::is_same_v<I, Bdf> || std::is_same_v<I, Rk8pd>;

constexpr Scales kScales{1.0, 1.0};

template <class I>
I make(double tolerance = 1e-8) {
  if constexpr (kIsAdaptive<I>) {
    return I(tolerance, kScales);
  } else {
    return I();
  }
}

/// Nine points of mass 1, bonds of length 1 and stiffness 1.
struct Patch {
  static constexpr BondLaw law(double eta) { return {1.0, 0.5, eta}; }

  explicit Patch(double eta)
      : lattice(triangular_patch(3)),
        field{BondForces(lattice, law(eta)), 1.0},
        state{0.0, 0, lattice.points, PointArray::Zero(9, 2)} {
    field.unstrained = std::make_shared<const PointArray>(lattice.points);
  }

  void add_velocity(double x, double y) {
    state.velocity.col(0) += x;
    state.velocity.col(1) += y;
  }

  /// Spinning, thrown at a soft wall that it leaves before t = 8.
  void throw_at_wall() {
    field.wall.emplace(2.0, 0.5);
    state.position.col(1) += 1.0;
    state.velocity.col(0) = 0.1 * state.position.col(1);
    add_velocity(0.0, -0.5);
  }

  template <class I>
  void advance(I&& integrator, double time, int steps) {
    integrator.restart(field, state);
    for (int k = 0; k < steps; ++k) integrator.step(field, state, time / steps);
  }

  Lattice lattice;
  ForceField field;
  State state;
};

template <class... I>
struct EachOf {
  using Types = testing::Types<I...>;
};
using All = EachOf<VelocityVerlet, TakahashiImada, BlanesMoan, ImplicitDamping, ExtrapolatedDamping,
                   Imex, Bdf, Rk8pd>::Types;
using TakingDamping =
    EachOf<VelocityVerlet, ImplicitDamping, ExtrapolatedDamping, Imex, Bdf, Rk8pd>::Types;
using OfFixedOrder = EachOf<VelocityVerlet, TakahashiImada, BlanesMoan, ImplicitDamping,
                            ExtrapolatedDamping, Imex, Rk8pd>::Types;
using RefusingDamping = EachOf<TakahashiImada, BlanesMoan>::Types;
using OfFixedStep =
    EachOf<VelocityVerlet, BlanesMoan, ImplicitDamping, ExtrapolatedDamping, Imex>::Types;
using Adaptive = EachOf<Bdf, Rk8pd>::Types;
using KeepingEnergy = EachOf<VelocityVerlet, TakahashiImada, BlanesMoan>::Types;

/// Of positions of order 1 and, in the bonds, of forces of order 1 over times of order 1, in tens
/// of steps.
constexpr double kRounding = 1e-13;

PointArray shifted(PointArray points, double x, double y) {
  points.col(0) += x;
  points.col(1) += y;
  return points;
}

template <class I>
class AnyIntegrator : public testing::Test {};
TYPED_TEST_SUITE(AnyIntegrator, All, );

/// A polynomial of degree 1, which every method of order 1 integrates exactly.
TYPED_TEST(AnyIntegrator, IsExactInFreeFlight) {
  Patch patch(0.0);
  patch.add_velocity(0.3, -0.2);
  patch.advance(make<TypeParam>(), 2.0, 20);
  const PointArray expected = shifted(patch.lattice.points, 0.6, -0.4);
  EXPECT_LT((patch.state.position - expected).abs().maxCoeff(), kRounding);
}

template <class I>
class DampedIntegrator : public testing::Test {};
TYPED_TEST_SUITE(DampedIntegrator, TakingDamping, );

/// Damping acts on relative velocities only.
TYPED_TEST(DampedIntegrator, IsExactInFreeFlight) {
  Patch patch(0.3);
  patch.add_velocity(0.3, -0.2);
  patch.advance(make<TypeParam>(), 2.0, 20);
  const PointArray expected = shifted(patch.lattice.points, 0.6, -0.4);
  EXPECT_LT((patch.state.position - expected).abs().maxCoeff(), kRounding);
}

template <class I>
class IntegratorOfFixedOrder : public testing::Test {};
TYPED_TEST_SUITE(IntegratorOfFixedOrder, OfFixedOrder, );

/// A polynomial of degree 2, which every method of order 2 integrates exactly; Bdf, which begins
/// with order 1, does not.
TYPED_TEST(IntegratorOfFixedOrder, IsExactUnderConstantAcceleration) {
  Patch patch(0.0);
  patch.field.load.emplace(2.7, patch.field.bonds.points());  // −0.3 on each point
  patch.add_velocity(0.1, 0.4);
  patch.advance(make<TypeParam>(), 2.0, 20);
  const PointArray expected = shifted(patch.lattice.points, 0.2, 0.8 - 0.5 * 0.3 * 4.0);
  EXPECT_LT((patch.state.position - expected).abs().maxCoeff(), kRounding);
  EXPECT_LT((patch.state.velocity.col(1) - (0.4 - 0.3 * 2.0)).abs().maxCoeff(), kRounding);
}

/// An error over what it was controlled by, a step or tolerance; both positive.
struct ErrorPoint {
  double control;
  double error;
};

/// The exponent p of a fit of error ∝ controlᵖ.
double exponent(const std::vector<ErrorPoint>& points) {
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (const ErrorPoint& point : points) {
    mean_x += std::log(point.control) / static_cast<double>(points.size());
    mean_y += std::log(point.error) / static_cast<double>(points.size());
  }
  double products = 0.0;
  double squares = 0.0;
  for (const ErrorPoint& point : points) {
    const double x = std::log(point.control) - mean_x;
    products += x * (std::log(point.error) - mean_y);
    squares += x * x;
  }
  return products / squares;
}

constexpr double kImpactTime = 8.0;

template <class I>
State after_impact(I&& integrator, double eta, int steps) {
  Patch patch(eta);
  patch.throw_at_wall();
  patch.advance(integrator, kImpactTime, steps);
  return patch.state;
}

/// Root of the sum of squares over all components, relative to the reference's velocities.
double difference(const State& state, const State& reference) {
  return std::sqrt(((state.position - reference.position).square().sum() +
                    (state.velocity - reference.velocity).square().sum()) /
                   reference.velocity.square().sum());
}

/// Good to 10⁻¹³, as its own tolerances say; another method finds the same up to what rounding
/// makes of its 3584 linear solutions.
State reference_of_impact(double eta) {
  const State reference = after_impact(Rk8pd(1e-15, kScales), eta, 1);
  EXPECT_LT(difference(after_impact(Rk8pd(1e-14, kScales), eta, 1), reference), 1e-13);
  EXPECT_LT(difference(after_impact(ExtrapolatedDamping(), eta, 512), reference), 3e-12);
  return reference;
}

/// The errors between 10⁻³ and `least` with ever shorter steps. The first resolves the fastest mode
/// of the lattice, ω = 2.4: a series in longer steps, with which Blanes–Moan errs by less than
/// 10⁻³, says nothing.
template <class I>
std::vector<ErrorPoint> errors_of_steps(double eta, double least) {
  const double shorter = std::pow(10.0, -0.5 / I::kOrder);  // √10 between errors
  const State reference = reference_of_impact(eta);
  std::vector<ErrorPoint> points;
  for (double step = 0.5; step > 1e-5; step *= shorter) {
    const int steps = static_cast<int>(std::lround(kImpactTime / step));
    const double error = difference(after_impact(I(), eta, steps), reference);
    if (error < least) break;
    if (error < 1e-3) points.push_back({kImpactTime / steps, error});
  }
  return points;
}

template <class I>
double observed_order(double eta) {
  // Order 2 takes some 10⁵ steps to 10⁻⁹; in more of them, each with the solution of a linear
  // system, rounding adds up to 10⁻¹⁰.
  const double least = I::kOrder == 2 ? 1e-9 : 1e-11;
  const std::vector<ErrorPoint> points = errors_of_steps<I>(eta, least);
  EXPECT_GE(points.size(), 7U);
  EXPECT_LT(points.back().error, 4.0 * least);
  return exponent(points);
}

template <class I>
class IntegratorOfFixedStep : public testing::Test {};
TYPED_TEST_SUITE(IntegratorOfFixedStep, OfFixedStep, );

TYPED_TEST(IntegratorOfFixedStep, HasItsOrder) {
  EXPECT_NEAR(observed_order<TypeParam>(0.0), TypeParam::kOrder, 0.1);
  if constexpr (!std::is_same_v<TypeParam, BlanesMoan>) {
    EXPECT_NEAR(observed_order<TypeParam>(0.03), TypeParam::kOrder, 0.1);
  }
}

template <class I>
class UndampedIntegrator : public testing::Test {};
TYPED_TEST_SUITE(UndampedIntegrator, RefusingDamping, );

TYPED_TEST(UndampedIntegrator, RefusesForcesThatDependOnVelocities) {
  Patch damped(0.1);
  EXPECT_THROW(TypeParam().restart(damped.field, damped.state), std::invalid_argument);
  Patch on_dashpots(0.0);
  on_dashpots.field.viscous_boundary.emplace(
      std::vector<ViscousBoundary::Dashpot>{{0, {1.0, 1.0}}});
  EXPECT_THROW(TypeParam().restart(on_dashpots.field, on_dashpots.state), std::invalid_argument);
}

/// Of a flight to a wall, which begins at 17 R/c and ends at 22 R/c, and back.
template <class I>
State in_flight(I&& integrator, double time, int steps) {
  Patch patch(0.0);
  patch.field.wall.emplace(4.0, 0.5);
  patch.state.velocity.col(0) = 0.1 * patch.state.position.col(1);
  patch.state.velocity.col(1) = -0.1 * patch.state.position.col(0);
  patch.state.position.col(1) += 9.0;  // the wall's force is below 10⁻¹⁵ there
  patch.add_velocity(0.0, -0.5);
  patch.advance(integrator, time, steps);
  return patch.state;
}

/// What is left of momentum and angular momentum.
Eigen::Array3d momenta(const State& state) {
  const auto x = (state.position.rowwise() - state.position.colwise().mean()).eval();
  const PointArray& v = state.velocity;
  return {v.col(0).sum(), v.col(1).sum(), (x.col(0) * v.col(1) - x.col(1) * v.col(0)).sum()};
}

/// Of order 4 where no forces act, of order 2 on the wall.
TEST(TakahashiImada, IsOfOrderFourFromFlightToFlight) {
  const State reference = in_flight(Rk8pd(1e-15, kScales), 40.0, 1);
  EXPECT_GT(reference.position.col(1).minCoeff(), 5.0);  // the wall's force is below 10⁻⁸ there
  std::vector<ErrorPoint> of_momenta;
  for (const int steps : {200, 280, 400, 560, 800}) {
    const State state = in_flight(TakahashiImada(), 40.0, steps);
    of_momenta.push_back({40.0 / steps, (momenta(state) - momenta(reference)).matrix().norm()});
  }
  EXPECT_NEAR(exponent(of_momenta), TakahashiImada::kOrder, 0.1);
  const State on_wall = in_flight(Rk8pd(1e-15, kScales), 19.0, 1);
  EXPECT_LT(on_wall.position.col(1).minCoeff(), 1.0);
  std::vector<ErrorPoint> of_points;
  for (const int steps : {190, 270, 380, 540}) {
    const State state = in_flight(TakahashiImada(), 19.0, steps);
    of_points.push_back({19.0 / steps, difference(state, on_wall)});
  }
  EXPECT_NEAR(exponent(of_points), 2.0, 0.1);
}

template <class I>
class AdaptiveIntegrator : public testing::Test {};
TYPED_TEST_SUITE(AdaptiveIntegrator, Adaptive, );

/// The error of a step is held to the tolerance, and the number of steps rises as
/// tolerance^(−1/(q + 1)) at order q: 5 of Bdf, 8 of Rk8pd. So the error falls as tolerance^(q/(q +
/// 1)) where the errors of all steps add up, in proportion where damping wipes them out. 0.1 for
/// the scatter, since each tolerance takes its own sequence of steps and orders.
TYPED_TEST(AdaptiveIntegrator, ErrorIsProportionalToTheTolerance) {
  constexpr double kScatter = 0.1;
  const double order = std::is_same_v<TypeParam, Bdf> ? 5.0 : 8.0;
  for (const double eta : {0.0, 0.3}) {
    const State reference = reference_of_impact(eta);
    std::vector<ErrorPoint> points;
    for (double tolerance = 1e-5; tolerance > 0.9e-11; tolerance /= std::sqrt(10.0)) {
      points.push_back(
          {tolerance, difference(after_impact(make<TypeParam>(tolerance), eta, 1), reference)});
    }
    EXPECT_GT(exponent(points), order / (order + 1.0) - kScatter) << eta;
    EXPECT_LT(exponent(points), 1.0 + kScatter) << eta;
  }
}

template <class I>
class EnergyKeepingIntegrator : public testing::Test {};
TYPED_TEST_SUITE(EnergyKeepingIntegrator, KeepingEnergy, );

/// A triangle that vibrates for 10⁶ steps of half the stability limit: the energy oscillates and
/// goes nowhere.
TYPED_TEST(EnergyKeepingIntegrator, KeepsTheEnergyInFreeVibration) {
  constexpr int kSteps = 1000000;
  constexpr int kSampling = 17;
  const Lattice lattice = triangle();
  const BondLaw law{1.0, 0.5, 0.0};
  ForceField field{BondForces(lattice, law), 1.0};
  State state{0.0, 0, lattice.points, PointArray::Zero(3, 2)};
  state.velocity << 0.03, -0.01, 0.0, 0.05, -0.02, 0.0;
  TypeParam integrator;
  const double h =
      0.5 * integrator.step_limit(lattice_spectrum(lattice, law, 1.0).omega_squared, 0.0);
  integrator.restart(field, state);
  std::vector<double> energy;
  for (int k = 0; k < kSteps; ++k) {
    integrator.step(field, state, h);
    if (k % kSampling != 0) continue;
    energy.push_back(0.5 * state.velocity.square().sum() +
                     field.bonds.potential_energy(state.position));
  }
  const Eigen::Map<const Eigen::VectorXd> sample(energy.data(),
                                                 static_cast<Eigen::Index>(energy.size()));
  // From −1/2 to 1/2: the slope of the fit is the change over the whole time.
  const Eigen::VectorXd time = Eigen::VectorXd::LinSpaced(sample.size(), -0.5, 0.5);
  const double change = time.dot(sample) / time.squaredNorm();
  EXPECT_LT(std::abs(change), sample.maxCoeff() - sample.minCoeff());
  EXPECT_GT(sample.maxCoeff() - sample.minCoeff(), 1e-12);  // that there is something to see
}

}  // namespace
}  // namespace impact
