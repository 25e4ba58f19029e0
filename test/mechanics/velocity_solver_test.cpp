#include "mechanics/velocity_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "test_lattices.hpp"

namespace impact {
namespace {

constexpr double kPatchMass = 0.1;
constexpr double kScale = 2.5;  // s D/m has eigenvalues up to 60
/// Of sums of some ten terms of up to 60.
constexpr double kRounding = 1e-13;

ForceField damped_patch() { return {BondForces(triangular_patch(4), {1.0, 0.5, 0.2}), kPatchMass}; }

PointArray some_velocities() {
  std::srand(5);
  return PointArray::Random(16, 2);
}

/// (1 + s D/m) u, from the damping forces −D u themselves.
PointArray product(ForceField field, const PointArray& u) {
  field.hold.reset();
  PointArray damping(16, 2);
  PointArray elastic(16, 2);
  const PointArray position = triangular_patch(4).points;
  field.evaluate(position, u, damping);
  field.evaluate_undamped(position, elastic);
  return u - kScale / kPatchMass * (damping - elastic);
}

PointArray solved(const ForceField& field, PointArray r) {
  VelocitySolver solver;
  solver.prepare(field, kScale);
  solver.solve(r);
  return r;
}

TEST(VelocitySolver, SolvesTheSystemOfTheBonds) {
  const ForceField field = damped_patch();
  const PointArray r = some_velocities();
  const PointArray u = solved(field, r);
  EXPECT_GT((u - r).abs().maxCoeff(), 0.1);
  EXPECT_LT((product(field, u) - r).abs().maxCoeff(), kRounding);
}

/// Relative velocities alone are damped.
TEST(VelocitySolver, KeepsTheMeanVelocity) {
  const PointArray r = some_velocities();
  const PointArray u = solved(damped_patch(), r);
  EXPECT_LT((u.colwise().mean() - r.colwise().mean()).abs().maxCoeff(), kRounding);
}

/// A dashpot that is stronger along x than along y: the two axes have different matrices.
TEST(VelocitySolver, SolvesTheSystemWithDashpots) {
  ForceField field = damped_patch();
  field.viscous_boundary.emplace(
      std::vector<ViscousBoundary::Dashpot>{{2, {0.3, 0.1}}, {9, {0.0, 0.4}}});
  const PointArray r = some_velocities();
  const PointArray u = solved(field, r);
  EXPECT_LT((product(field, u) - r).abs().maxCoeff(), kRounding);
  EXPECT_GT((u - solved(damped_patch(), r)).abs().maxCoeff(), 0.1);
}

/// The velocity of a supported coordinate, zero in any motion, stays what it is.
TEST(VelocitySolver, SolvesTheSystemWithSupports) {
  ForceField field = damped_patch();
  field.supports.emplace(std::vector<std::int32_t>{0, 7}, std::vector<std::int32_t>{5});
  PointArray r = some_velocities();
  r(0, 0) = r(7, 0) = r(5, 1) = 0.0;
  const PointArray u = solved(field, r);
  EXPECT_EQ(u(0, 0), 0.0);
  EXPECT_EQ(u(7, 0), 0.0);
  EXPECT_EQ(u(5, 1), 0.0);
  EXPECT_LT((product(field, u) - r).abs().maxCoeff(), kRounding);
}

/// With the constraint's direction c and a multiplier λ, (1 + s D/m) u = r + λ c and c · u = 0.
TEST(VelocitySolver, KeepsTheRotationHeld) {
  ForceField field = damped_patch();
  field.hold.emplace(triangular_patch(4).points);
  const PointArray& c = field.hold->direction();
  const PointArray r = some_velocities();
  const PointArray u = solved(field, r);
  EXPECT_NEAR((c * u).sum(), 0.0, 10.0 * kRounding);  // 32 products of up to 3
  const PointArray excess = product(field, u) - r;
  const double multiplier = (c * excess).sum() / c.square().sum();
  EXPECT_GT(std::abs(multiplier), 1e-3);
  EXPECT_LT((excess - multiplier * c).abs().maxCoeff(), 10.0 * kRounding);
}

}  // namespace
}  // namespace impact
