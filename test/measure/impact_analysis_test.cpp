#include "measure/impact_analysis.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace impact {
namespace {

State square_with_velocity(double vx, double vy, double spin) {
  State state;
  state.position.resize(4, 2);
  state.position << 1, 1, -1, 1, -1, -1, 1, -1;
  state.velocity.resize(4, 2);
  state.velocity.col(0) = vx - spin * state.position.col(1);
  state.velocity.col(1) = vy + spin * state.position.col(0);
  return state;
}

State lowered(State state, double way) {
  state.position.col(1) -= way;
  return state;
}

TEST(ImpactAnalysis, NeedsNoPointsAtAWall) {
  ImpactAnalysis of_states;
  ImpactAnalysis of_motions;
  for (const double v : {-2.0, 1.5}) {
    const State state = square_with_velocity(0.25, v, 0.5 * v);
    of_states.add(state);
    of_motions.add(body_motion(state.position, state.velocity));
  }
  const Restitution expected = of_states.restitution(true);
  const Restitution result = of_motions.restitution(true);
  EXPECT_EQ(result.restitution, 0.75);
  EXPECT_EQ(result.spin_after, expected.spin_after);
  EXPECT_EQ(result.energy_restitution, expected.energy_restitution);
  EXPECT_EQ(result.tangential_restitution, expected.tangential_restitution);
}

/// A triangular pulse of height 2 and base 2 about t = 2.
double force(double time) { return std::max(0.0, 2.0 - 2.0 * std::abs(time - 2.0)); }

/// The impact, with a report every `period` steps of 1/8.
Restitution analysed(int period, bool separated) {
  ImpactAnalysis analysis;
  analysis.add(square_with_velocity(0.0, -2.0, 0.0));
  ContactReport report;
  for (int k = 0; k <= 32; ++k) {
    report.samples.push_back({k / 8.0, force(k / 8.0)});
    if (k % period == 0) {
      analysis.add(report);
      report = ContactReport{};
    }
  }
  analysis.add(report);
  analysis.add(square_with_velocity(0.25, 1.5, -0.5));
  return analysis.restitution(separated);
}

TEST(ImpactAnalysis, ComparesTheMotionBeforeAndAfter) {
  const Restitution result = analysed(1, true);
  EXPECT_EQ(result.velocity_before, -2.0);
  EXPECT_EQ(result.velocity_after, 1.5);
  EXPECT_EQ(result.restitution, 0.75);
  EXPECT_EQ(result.tangential_velocity_after, 0.25);
  EXPECT_DOUBLE_EQ(result.spin_after, -0.5);
  // 1.5² + 0.25² and, with the moment of inertia 2, 2·0.5², over 2².
  EXPECT_DOUBLE_EQ(result.energy_restitution, std::sqrt((2.25 + 0.0625 + 0.5) / 4.0));
  EXPECT_TRUE(std::isnan(result.tangential_restitution));  // it did not slide
  EXPECT_EQ(result.peak_force, 2.0);
  EXPECT_DOUBLE_EQ(result.impulse, 2.0);
  // 2·10⁻³ is crossed one thousandth of the way up and down, linearly from and to zero.
  EXPECT_NEAR(result.contact_begin, 1.001, 1e-12);
  EXPECT_NEAR(result.contact_end, 2.999, 1e-12);
}

/// A square (k² = 2) that comes at (3, −2) with the spin 1, energy 9 + 4 + 2·1 = 15, and leaves at
/// (1, 1) with the spin −0.5: the surface above the wall moved at 3 + 1 and then at 1 − 0.5.
TEST(ImpactAnalysis, MeasuresAnObliqueImpact) {
  ImpactAnalysis analysis;
  analysis.add(square_with_velocity(3.0, -2.0, 1.0));
  analysis.add(square_with_velocity(1.0, 1.0, -0.5));
  const Restitution result = analysis.restitution(true);
  EXPECT_DOUBLE_EQ(result.tangential_velocity_before, 3.0);
  EXPECT_DOUBLE_EQ(result.spin_before, 1.0);
  EXPECT_DOUBLE_EQ(result.tangential_restitution, -0.5 / 4.0);
  EXPECT_DOUBLE_EQ(result.impulse_ratio, -2.0 / 3.0);
  EXPECT_DOUBLE_EQ(result.normal_energy, 1.0 / 15.0);
  EXPECT_DOUBLE_EQ(result.tangential_energy, 1.0 / 15.0);
  EXPECT_DOUBLE_EQ(result.rotation_energy, 0.5 / 15.0);
  EXPECT_DOUBLE_EQ(std::pow(result.energy_restitution, 2), 2.5 / 15.0);
}

/// Two squares of mass 1 as seen from their centre of mass, of inertia 2 each: before, (1.5, −1)
/// and the opposite, the first one spinning at 1, energy 2 (2.25 + 1) + 2 = 8.5; after, (0.5, 0.5)
/// and the opposite, spins −0.5 and 0.25. The second one is touched 1 above its middle.
TEST(ImpactAnalysis, CountsBothOfTwoDisks) {
  ImpactAnalysis analysis;
  analysis.add(square_with_velocity(1.5, -1.0, 1.0),
               {lowered(square_with_velocity(-1.5, 1.0, 0.0), 2.0)});
  analysis.add(square_with_velocity(0.5, 0.5, -0.5),
               {lowered(square_with_velocity(-0.5, -0.5, 0.25), 2.0)});
  const Restitution result = analysis.restitution(true);
  EXPECT_EQ(result.restitution, 0.5);
  EXPECT_DOUBLE_EQ(result.energy_before, 4.25);
  EXPECT_DOUBLE_EQ(result.normal_energy, 0.5 / 8.5);
  EXPECT_DOUBLE_EQ(result.tangential_energy, 0.5 / 8.5);
  EXPECT_DOUBLE_EQ(result.rotation_energy, 2.0 * (0.25 + 0.0625) / 8.5);
  EXPECT_DOUBLE_EQ(result.energy_restitution, std::sqrt(1.625 / 8.5));
  // 1.5 + 1 against −1.5, then 0.5 − 0.5 against −0.5 − 0.25.
  EXPECT_DOUBLE_EQ(result.tangential_restitution, -0.75 / 4.0);
  EXPECT_EQ(result.wall_velocity_after, -0.5);
  EXPECT_EQ(result.wall_tangential_velocity_after, -0.5);
  EXPECT_DOUBLE_EQ(result.wall_spin_after, 0.25);
  EXPECT_TRUE(std::isnan(result.wall2_velocity_after));
  EXPECT_TRUE(std::isnan(result.momentum_passed_on));
}

/// A disk meets two of its size, which are at rest against each other, at 3. The last one leaves at
/// 2.25 of those 3.
TEST(ImpactAnalysis, SaysWhatTheLastDiskOfARowTookOver) {
  const State resting = square_with_velocity(0.0, 1.0, 0.0);
  ImpactAnalysis analysis;
  analysis.add(square_with_velocity(0.0, -2.0, 0.0), {resting, resting});
  analysis.add(square_with_velocity(0.0, 0.75, 0.0),
               {square_with_velocity(0.25, 0.5, 0.5), square_with_velocity(-0.25, -1.25, -0.125)});
  const Restitution result = analysis.restitution(true);
  EXPECT_DOUBLE_EQ(result.momentum_passed_on, 0.75);
  EXPECT_DOUBLE_EQ(result.restitution_of_ends, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(result.restitution, 0.375);
  EXPECT_EQ(result.wall_velocity_after, 0.5);
  EXPECT_EQ(result.wall2_velocity_after, -1.25);
  EXPECT_EQ(result.wall2_tangential_velocity_after, -0.25);
  EXPECT_DOUBLE_EQ(result.wall2_spin_after, -0.125);
  EXPECT_TRUE(std::isnan(result.wall3_spin_after));
  // 4 + 1 + 1 before; 0.5625 + 0.25 + 1.5625 along y and 0.125 along x after.
  EXPECT_DOUBLE_EQ(result.normal_energy, 2.375 / 6.0);
  EXPECT_DOUBLE_EQ(result.tangential_energy, 0.125 / 6.0);
}

/// The second one four times as heavy.
TEST(ImpactAnalysis, WeighsTheSecondDisk) {
  const State light = square_with_velocity(0.0, -4.0, 0.0);
  State heavy;
  heavy.position.resize(16, 2);
  heavy.velocity.resize(16, 2);
  for (int k = 0; k < 16; ++k) {
    heavy.position.row(k) << k % 4, k / 4;
    heavy.velocity.row(k) << 0.0, 1.0;
  }
  ImpactAnalysis analysis;
  analysis.add(light, {heavy});
  EXPECT_DOUBLE_EQ(analysis.restitution(false).energy_before, 0.5 * (16.0 + 4.0));
}

/// Falls from 0.75 above where it touches: 2² + 2·2·0.75 = 7. It is seen to rise at 1 when it is
/// 0.25 above.
TEST(ImpactAnalysis, TakesVelocitiesUnderGravityWhereTheDiskTouches) {
  ImpactAnalysis analysis(2.0);
  State start = square_with_velocity(0.0, -2.0, 0.0);
  start.position.col(1) += 1.75;
  State end = square_with_velocity(0.0, 1.0, 0.0);
  end.position.col(1) += 1.25;
  analysis.add(start);
  analysis.add(end);
  const Restitution result = analysis.restitution(true);
  EXPECT_DOUBLE_EQ(result.velocity_before, -std::sqrt(7.0));
  EXPECT_DOUBLE_EQ(result.velocity_after, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(result.restitution, std::sqrt(2.0 / 7.0));
  EXPECT_DOUBLE_EQ(result.energy_before, 3.5);
}

/// A disk that leaves swollen has the spin that it will have at its size before: L/I.
TEST(ImpactAnalysis, MeasuresSpinByTheMomentOfInertiaBefore) {
  ImpactAnalysis analysis;
  analysis.add(square_with_velocity(0.0, -2.0, 0.0));
  State swollen = square_with_velocity(0.0, 1.5, 0.5);
  swollen.position *= 2.0;
  analysis.add(swollen);
  const Restitution result = analysis.restitution(true);
  EXPECT_DOUBLE_EQ(result.spin_after, 2.0 * 0.5);
  EXPECT_DOUBLE_EQ(result.energy_restitution, std::sqrt((2.25 + 2.0 * 1.0) / 4.0));
}

TEST(ImpactAnalysis, DoesNotDependOnHowOftenItIsTold) {
  const Restitution often = analysed(1, true);
  const Restitution seldom = analysed(10, true);
  EXPECT_EQ(often.impulse, seldom.impulse);
  EXPECT_EQ(often.contact_begin, seldom.contact_begin);
  EXPECT_EQ(often.contact_duration, seldom.contact_duration);
}

TEST(ImpactAnalysis, KnowsNoResultBeforeTheDiskHasLeft) {
  EXPECT_TRUE(std::isnan(ImpactAnalysis().restitution(false).velocity_before));
  const Restitution result = analysed(1, false);
  EXPECT_EQ(result.velocity_before, -2.0);
  EXPECT_TRUE(std::isnan(result.restitution));
  EXPECT_TRUE(std::isnan(result.contact_duration));
  EXPECT_TRUE(std::isnan(result.peak_force));
}

}  // namespace
}  // namespace impact
