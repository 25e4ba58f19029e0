#include "mechanics/lane_bundle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include "every_kernel.hpp"
#include "lattice/placement.hpp"
#include "mechanics/blanes_moan.hpp"
#include "mechanics/extrapolated_damping.hpp"
#include "mechanics/implicit_damping.hpp"
#include "mechanics/simulation.hpp"
#include "mechanics/takahashi_imada.hpp"
#include "mechanics/velocity_verlet.hpp"
#include "two_bodies.hpp"

namespace impact {
namespace {

constexpr int kPoints = 101;  // fills no whole slice
constexpr double kPointMass = 1.0 / kPoints;

const Lattice& disk() {
  static const Lattice lattice = triangulated_lattice(place_in_disk({kPoints}, 1));
  return lattice;
}

/// A disk on its way to the wall.
struct Throw {
  double speed;
  double k_a = 1.0;
  double eta = 0.0;
  double a = 300.0;
  double step = 0.01;
  double k_b = 1e-3;
};

ForceField field_of(const Throw& thrown) {
  ForceField field{BondForces(disk(), {thrown.k_a, thrown.k_b, thrown.eta}), kPointMass};
  field.wall.emplace(thrown.a, thrown.a * kPointMass);
  return field;
}

State start_of(const Throw& thrown) {
  State state{0.0, 0, disk().points, PointArray::Zero(kPoints, 2)};
  state.position.col(1) += 1.05;
  state.velocity.col(0) = 0.1 * thrown.speed * disk().points.col(1);
  state.velocity.col(1) -= thrown.speed;
  return state;
}

Spectrum spectrum_of(const Throw& thrown) {
  return lattice_spectrum(disk(), {thrown.k_a, thrown.k_b, thrown.eta}, kPointMass);
}

template <template <class> class I>
Simulation alone(const Throw& thrown) {
  return {field_of(thrown), start_of(thrown), spectrum_of(thrown), thrown.step,
          std::make_unique<I<ForceField>>()};
}

template <template <class> class I>
std::unique_ptr<LaneMotion> in_lane(const Throw& thrown) {
  return std::make_unique<LaneMotion>(field_of(thrown), start_of(thrown), spectrum_of(thrown),
                                      thrown.step, std::make_unique<I<ForceField>>());
}

template <template <class> class I>
LaneBundle bundle(const Throw& like, bool needs_common_step = false) {
  return {disk(), kPointMass, LaneField::kind_of(field_of(like)), std::make_unique<I<LaneField>>(),
          needs_common_step};
}

/// To the last bit.
void expect_same(const Motion& motion, const Motion& expected) {
  ASSERT_EQ(motion.steps(), expected.steps());
  EXPECT_EQ(motion.time(), expected.time());
  EXPECT_EQ(motion.step_size(), expected.step_size());
  EXPECT_TRUE((motion.state().position == expected.state().position).all());
  EXPECT_TRUE((motion.state().velocity == expected.state().velocity).all());
  EXPECT_EQ(motion.field().wall->total_force().y(), expected.field().wall->total_force().y());
  EXPECT_EQ(motion.field().wall->largest_force(), expected.field().wall->largest_force());
  EXPECT_EQ(motion.field().evaluations, expected.field().evaluations);
  EXPECT_EQ(motion.ledger().total(), expected.ledger().total());
  EXPECT_EQ(motion.ledger().dissipated, expected.ledger().dissipated);
}

/// Each alone, and all in lanes: the first few, then one more every tenth step, through impact.
template <template <class> class I>
void expect_same_in_lanes(const std::vector<Throw>& throws, bool needs_common_step = false) {
  std::vector<Simulation> singles;
  std::vector<std::unique_ptr<LaneMotion>> motions;
  LaneBundle all = bundle<I>(throws.front(), needs_common_step);
  constexpr int kSteps = 400;
  for (int step = 0; step < kSteps; ++step) {
    while (motions.size() < throws.size() &&
           (motions.size() < 3 || step >= 10 * static_cast<int>(motions.size()))) {
      singles.push_back(alone<I>(throws[motions.size()]));
      motions.push_back(in_lane<I>(throws[motions.size()]));
      all.add(*motions.back());
      expect_same(*motions.back(), singles.back());
    }
    all.step();
    for (Simulation& single : singles) single.step();
  }
  for (std::size_t i = 0; i < motions.size(); ++i) {
    SCOPED_TRACE(i);
    expect_same(*motions[i], singles[i]);
    EXPECT_LT(start_of(throws[i]).velocity.col(1).mean(),
              motions[i]->state().velocity.col(1).mean());
  }
}

TEST(LaneBundle, IsVelocityVerletInEveryLane) {
  expect_same_in_lanes<BasicVelocityVerlet>({{0.02},
                                             {0.05, 1.1},
                                             {0.03, 0.9, 0.0, 200.0, 0.008},
                                             {0.02},
                                             {0.06, 1.0, 0.0, 300.0, 0.01, 0.5}});
}

TEST(LaneBundle, IsDampedVelocityVerletInEveryLane) {
  expect_same_in_lanes<BasicVelocityVerlet>({{0.02, 1.0, kPointMass},
                                             {0.05, 1.1, 2.0 * kPointMass},
                                             {0.03, 0.9, 0.5 * kPointMass, 200.0, 0.008}});
}

TEST(LaneBundle, IsTakahashiImadaInEveryLane) {
  expect_same_in_lanes<BasicTakahashiImada>(
      {{0.02}, {0.05, 1.1}, {0.03, 0.9, 0.0, 200.0, 0.008}, {0.02}});
}

TEST(LaneBundle, IsBlanesMoanInEveryLane) {
  expect_same_in_lanes<BasicBlanesMoan>(
      {{0.02}, {0.05, 1.1}, {0.03, 0.9, 0.0, 200.0, 0.008}, {0.02}});
}

TEST(LaneBundle, IsImplicitDampingInEveryLane) {
  const double eta = 30.0 * kPointMass;
  expect_same_in_lanes<BasicImplicitDamping>(
      {{0.02, 1.0, eta}, {0.05, 1.1, eta}, {0.03, 0.9, eta, 200.0}, {0.02, 1.0, eta}}, true);
}

TEST(LaneBundle, IsExtrapolatedDampingInEveryLane) {
  const double eta = 30.0 * kPointMass;
  expect_same_in_lanes<BasicExtrapolatedDamping>(
      {{0.02, 1.0, eta}, {0.05, 1.1, eta}, {0.03, 0.9, eta, 200.0}, {0.02, 1.0, eta}}, true);
}

/// Eqs. (1) and (3), bond by bond and point by point.
struct PlainForces {
  PointArray force = PointArray::Zero(kPoints, 2);
  double power = 0.0;
  double wall = 0.0;
  double largest = 0.0;

  PlainForces(const Throw& thrown, const PointArray& position, const PointArray& velocity) {
    for (std::size_t k = 0; k < disk().bonds.size(); ++k) {
      const auto [i, j] = disk().bonds[k];
      const Eigen::Array<double, 1, 2> way = position.row(i) - position.row(j);
      const Eigen::Array<double, 1, 2> dv = velocity.row(i) - velocity.row(j);
      const double x = way.matrix().norm() - disk().natural_lengths[k];
      const double tension = thrown.k_a * x + thrown.k_b * x * x * x;
      const auto pull = (-tension * way.matrix().normalized().array() - thrown.eta * dv).eval();
      force.row(i) += pull;
      force.row(j) -= pull;
      power += thrown.eta * dv.square().sum();
    }
    for (int i = 0; i < kPoints; ++i) {
      const double push = thrown.a * thrown.a * kPointMass * std::exp(-thrown.a * position(i, 1));
      force(i, 1) += push;
      wall += push;
      largest = std::max(largest, push);
    }
  }
};

/// Velocity Verlet by plain loops, through the impact: rounding of 10⁻¹⁶ grows over 400 steps.
TEST(LaneBundle, FollowsAPlainLoop) {
  const std::vector<Throw> throws{{0.02}, {0.05, 1.1}, {0.06, 1.0, 0.0, 200.0, 0.008, 0.5}};
  LaneBundle all = bundle<BasicVelocityVerlet>(throws.front());
  std::vector<std::unique_ptr<LaneMotion>> motions;
  for (const Throw& thrown : throws) {
    motions.push_back(in_lane<BasicVelocityVerlet>(thrown));
    all.add(*motions.back());
  }
  constexpr int kSteps = 400;
  for (int step = 0; step < kSteps; ++step) all.step();
  for (std::size_t k = 0; k < throws.size(); ++k) {
    PointArray x = start_of(throws[k]).position;
    PointArray v = start_of(throws[k]).velocity;
    const auto kick = [&] {
      v += 0.5 * throws[k].step / kPointMass * PlainForces(throws[k], x, v).force;
    };
    for (int step = 0; step < kSteps; ++step) {
      kick();
      x += throws[k].step * v;
      kick();
    }
    EXPECT_LT((motions[k]->state().position - x).abs().maxCoeff(), 1e-10);
    EXPECT_LT((motions[k]->state().velocity - v).abs().maxCoeff(), 1e-10);
    EXPECT_NEAR(motions[k]->kinetic_energy(), 0.5 * kPointMass * v.square().sum(), 1e-12);
    EXPECT_GT(v.col(1).mean(), 0.0);
  }
}

/// The wall grows too stiff for this step on the way.
TEST(LaneBundle, HalvesTheStepOfOneLane) {
  const Throw hard{0.3, 1.0, 0.0, 1000.0, 0.03};
  Simulation single = alone<BasicVelocityVerlet>(hard);
  const auto motion = in_lane<BasicVelocityVerlet>(hard);
  const auto other = in_lane<BasicVelocityVerlet>({0.02});
  LaneBundle both = bundle<BasicVelocityVerlet>(hard);
  both.add(*other);
  both.add(*motion);
  for (int step = 0; step < 100; ++step) {
    both.step();
    single.step();
  }
  EXPECT_GT(motion->halvings(), 0);
  EXPECT_EQ(other->halvings(), 0);
  expect_same(*motion, single);
}

/// Above an elastic wall that rises: it counts how fast the two bodies come together.
TEST(LaneBundle, HalvesTheStepAboveAnElasticWall) {
  TwoBodies bodies(2.4, {0.3, 0.0}, GapMeasure::kNormal, 4000.0);
  bodies.state.velocity.bottomRows(bodies.field.other_points()).col(1) += 0.1;
  Simulation single = bodies.simulation(0.1);
  LaneMotion motion(bodies.field, bodies.state, bodies.spectrum(), 0.1,
                    std::make_unique<VelocityVerlet>());
  LaneBundle lanes(bodies.lattice, TwoBodies::kMass, LaneField::kind_of(bodies.field),
                   std::make_unique<BasicVelocityVerlet<LaneField>>(), false);
  lanes.add(motion);
  while (single.time() < 6.0) {
    single.step();
    lanes.step();
    ASSERT_EQ(motion.halvings(), single.halvings());
  }
  EXPECT_GT(single.halvings(), 0);
  EXPECT_TRUE((motion.state().position == single.state().position).all());
  EXPECT_TRUE((motion.state().velocity == single.state().velocity).all());
  EXPECT_GT(single.field().elastic_wall->largest_force(), 0.0);
}

using Change = std::function<void(ForceField&)>;

/// Damped disks and elastic walls, changed so, in lanes and alone.
template <template <class> class I>
void expect_same_on_elastic_wall(const std::vector<Change>& changes, bool needs_common_step) {
  constexpr double kStep = 0.02;
  std::deque<TwoBodies> all;
  std::deque<Simulation> singles;
  std::deque<LaneMotion> motions;
  for (const Change& change : changes) {
    const double place = 2.4 + 0.3 * static_cast<double>(all.size());
    all.emplace_back(place, Eigen::Array2d(0.1, -0.3), GapMeasure::kNormal, 40.0, 0.1);
    change(all.back().field);
    singles.push_back(all.back().simulation<I>(kStep));
    motions.emplace_back(all.back().field, all.back().state, all.back().spectrum(), kStep,
                         std::make_unique<I<ForceField>>());
  }
  LaneBundle lanes(all[0].lattice, TwoBodies::kMass, LaneField::kind_of(all[0].field),
                   std::make_unique<I<LaneField>>(), needs_common_step);
  for (LaneMotion& motion : motions) lanes.add(motion);
  for (int step = 0; step < 200; ++step) {
    lanes.step();
    for (Simulation& single : singles) single.step();
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    SCOPED_TRACE(k);
    EXPECT_TRUE((motions[k].state().position == singles[k].state().position).all());
    EXPECT_TRUE((motions[k].state().velocity == singles[k].state().velocity).all());
    EXPECT_EQ(motions[k].ledger().dissipated, singles[k].ledger().dissipated);
    EXPECT_EQ(motions[k].ledger().absorbed, singles[k].ledger().absorbed);
    EXPECT_EQ(motions[k].field().evaluations, singles[k].field().evaluations);
    EXPECT_GT(singles[k].ledger().dissipated, 0.0);
    EXPECT_GT(singles[k].state().velocity.topRows(TwoBodies::kDiskPoints).col(1).mean(), 0.0);
  }
}

void clamp(ForceField& field) { field.supports.emplace(TwoBodies::bottom(), TwoBodies::bottom()); }

Change reset_every(double interval) {
  return [interval](ForceField& field) {
    field.velocity_reset.emplace(TwoBodies::bottom(), interval);
  };
}

/// A reset changes the velocities of one lane, and the damping with them.
TEST(LaneBundle, HoldsAndResetsDampedElasticWallsInEveryLane) {
  const Change leave = [](ForceField& /*field*/) {};
  expect_same_on_elastic_wall<BasicVelocityVerlet>(
      {clamp, reset_every(0.02), leave, reset_every(0.06)}, false);
  expect_same_on_elastic_wall<BasicImplicitDamping>({reset_every(0.02), leave, reset_every(0.06)},
                                                    true);
  expect_same_on_elastic_wall<BasicExtrapolatedDamping>(
      {reset_every(0.02), leave, reset_every(0.06)}, true);
  expect_same_on_elastic_wall<BasicImplicitDamping>({clamp, clamp}, true);
  expect_same_on_elastic_wall<BasicExtrapolatedDamping>({clamp, clamp}, true);
}

TEST(LaneBundle, OneWhoseStepIsHalvedLeavesACommonOne) {
  const double eta = 30.0 * kPointMass;
  const Throw hard{0.3, 1.0, eta, 1000.0, 0.03};
  const auto motion = in_lane<BasicImplicitDamping>(hard);
  const auto other = in_lane<BasicImplicitDamping>({0.02, 1.0, eta, 300.0, 0.03});
  LaneBundle both = bundle<BasicImplicitDamping>(hard, true);
  both.add(*other);
  both.add(*motion);
  for (int step = 0; step < 100 && motion->is_in_bundle(); ++step) both.step();
  EXPECT_FALSE(motion->is_in_bundle());
  EXPECT_GT(motion->halvings(), 0);
  EXPECT_TRUE(other->is_in_bundle());

  // In other bundles it goes on as alone.
  Simulation single = alone<BasicImplicitDamping>(hard);
  while (single.steps() < motion->steps()) single.step();
  for (int step = 0; step < 20; ++step) {
    LaneBundle next = bundle<BasicImplicitDamping>(hard, true);
    next.add(*motion);
    next.step();
  }
  while (single.steps() < motion->steps()) single.step();
  EXPECT_GT(single.steps(), 10U);
  expect_same(*motion, single);
}

TEST(LaneBundle, AMotionThatLeavesKeepsItsStateAndFreesItsLane) {
  const Throw thrown{0.02};
  std::array<std::unique_ptr<LaneMotion>, kLanes> motions;
  PointArray position;
  {
    LaneBundle all = bundle<BasicVelocityVerlet>(thrown);
    for (auto& motion : motions) {
      EXPECT_FALSE(all.is_full());
      motion = in_lane<BasicVelocityVerlet>(thrown);
      all.add(*motion);
    }
    EXPECT_TRUE(all.is_full());
    all.step();
    motions[3].reset();
    EXPECT_FALSE(all.is_full());
    all.step();
    position = motions[4]->state().position;
  }
  EXPECT_FALSE(motions[4]->is_in_bundle());
  EXPECT_EQ(motions[4]->steps(), 2U);
  EXPECT_TRUE((motions[4]->state().position == position).all());
}

/// What is not finite in one lane stays there.
TEST(LaneBundle, ABlowUpDoesNotSpread) {
  const Throw thrown{0.02};
  Simulation single = alone<BasicVelocityVerlet>(thrown);
  const auto motion = in_lane<BasicVelocityVerlet>(thrown);
  State lost = start_of(thrown);
  lost.position(5, 0) = std::nan("");
  LaneMotion blown_up(field_of(thrown), lost, spectrum_of(thrown), 0.01,
                      std::make_unique<VelocityVerlet>());
  LaneBundle both = bundle<BasicVelocityVerlet>(thrown);
  both.add(blown_up);
  both.add(*motion);
  for (int step = 0; step < 50; ++step) {
    both.step();
    single.step();
  }
  EXPECT_FALSE(std::isfinite(blown_up.kinetic_energy()));
  expect_same(*motion, single);
}

TEST(LaneField, KnowsTheTermsOfAnImpactOnThePotentialWall) {
  ForceField field = field_of({0.02});
  EXPECT_TRUE(LaneField::knows(field));
  LaneField lanes(disk(), kPointMass, LaneField::kind_of(field));
  EXPECT_NO_THROW(lanes.set_lane(0, field));
  field.load.emplace(1.0, field.bonds.points());
  EXPECT_FALSE(LaneField::knows(field));
  EXPECT_THROW(lanes.set_lane(0, field), std::logic_error);
  field.load.reset();
  field.supports.emplace(std::vector<std::int32_t>{0}, std::vector<std::int32_t>{});
  EXPECT_FALSE(LaneField::knows(field));
}

class EveryLaneKernel : public KernelTest {};

/// Forces, power and wall of each lane are those of one run, to the last bit, and of a plain loop.
TEST_P(EveryLaneKernel, HasTheBitsOfOneRun) {
  const Kernels& kernels = *GetParam();
  for (const double k_b : {0.0, 0.5}) {
    for (const double eta : {0.0, 0.3}) {
      std::vector<Throw> throws;
      for (int k = 0; k < kLanes; ++k)
        throws.push_back({0.01 * k, 1.0 + k, eta * k, 100.0 + k, 0.01, k_b});
      throws.front() = throws.back();
      LaneField lanes(disk(), kPointMass, {k_b != 0.0, eta != 0.0}, kernels);
      LaneState state;
      std::deque<ForceField> fields;
      LaneArray force;
      for (LaneArray* const array : {&state.position, &state.velocity, &force})
        lanes.resize(*array);
      for (int k = 0; k < kLanes; ++k) {
        const State start = start_of(throws[static_cast<std::size_t>(k)]);
        fields.push_back(field_of(throws[static_cast<std::size_t>(k)]));
        lanes.set_lane(k, fields.back());
        state.position.lane(k) = (1.0 + 0.001 * k) * start.position;
        state.velocity.lane(k) = start.velocity;
      }
      const LaneLosses power = lanes.evaluate(state.position, state.velocity, force);
      for (int k = 0; k < kLanes; ++k) {
        const Throw& thrown = throws[static_cast<std::size_t>(k)];
        BondForces bonds(disk(), {thrown.k_a, k_b, thrown.eta}, kernels);
        PointArray expected(kPoints, 2);
        const PointArray position = state.position.lane(k);
        const double lost = bonds.evaluate(position, state.velocity.lane(k), expected);
        const WallForce wall = kernels.potential_wall(
            field_of(thrown).wall->law(), position.col(1).data(), kPoints, expected.col(1).data());
        EXPECT_TRUE((force.lane(k) == expected).all()) << k;
        EXPECT_EQ(power.dissipated(k), lost);
        EXPECT_EQ(lanes.wall_force(k).total, wall.total);
        EXPECT_EQ(lanes.wall_force(k).largest, wall.largest);
        EXPECT_GT(wall.total, 0.0);

        // Rounding of forces of about 1, and of exponentials to 4 units in the last place.
        const PlainForces plain(thrown, position, state.velocity.lane(k));
        EXPECT_LT((force.lane(k) - plain.force).abs().maxCoeff(), 1e-13);
        EXPECT_NEAR(power.dissipated(k), plain.power, 1e-14);
        EXPECT_NEAR(wall.total, plain.wall, 1e-13);
        EXPECT_NEAR(wall.largest, plain.largest, 1e-13);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, EveryLaneKernel, all_kernels(), kernel_name);

}  // namespace
}  // namespace impact
