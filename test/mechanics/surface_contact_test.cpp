#include "mechanics/surface_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>

namespace impact {
namespace {

constexpr Eigen::Index kDiskPoints = 12;
constexpr int kSurfacePoints = 7;
constexpr double kThreshold = 0.5;
const Repulsion kLaw(10.0, 0.1);

/// Row of the k-th surface point from the left; they are stored from right to left.
int row_of(int k) { return static_cast<int>(kDiskPoints) + kSurfacePoints - 1 - k; }

std::vector<std::int32_t> rows_below(Eigen::Index end) {
  std::vector<std::int32_t> rows(static_cast<std::size_t>(end));
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

std::vector<std::int32_t> surface() {
  std::vector<std::int32_t> rows;
  for (int k = 0; k < kSurfacePoints; ++k) rows.push_back(row_of(k));
  return rows;
}

/// A wavy surface from x = 0 to 6 and, at random places close above it, the points of the disk.
PointArray random_configuration(unsigned seed) {
  std::srand(seed);
  PointArray position = 0.2 * PointArray::Random(kDiskPoints + kSurfacePoints, 2);
  for (int k = 0; k < kSurfacePoints; ++k) position(row_of(k), 0) += k;
  position.col(0).head(kDiskPoints) = 3.0 + 14.0 * position.col(0).head(kDiskPoints);
  position.col(1).head(kDiskPoints) += 0.2;
  return position;
}

SurfaceContact wall_at(const PointArray& position, GapMeasure measure) {
  return SurfaceContact(kLaw, kThreshold, measure, rows_below(kDiskPoints), surface(), position);
}

PointArray forces(SurfaceContact& wall, const PointArray& position) {
  PointArray force = PointArray::Zero(position.rows(), 2);
  wall.add_forces(position, force);
  wall.count_hops(position);
  return force;
}

double torque(const PointArray& position, const PointArray& force) {
  return (position.col(0) * force.col(1) - position.col(1) * force.col(0)).sum();
}

/// What is above a bond, found by looking at every bond.
struct Below {
  double slope;
  double vertical_gap;
  double gap(GapMeasure measure) const {
    return measure == GapMeasure::kVertical ? vertical_gap
                                            : vertical_gap / std::sqrt(1.0 + slope * slope);
  }
};

std::optional<Below> below(const PointArray& position, Eigen::Index point) {
  for (int k = 0; k + 1 < kSurfacePoints; ++k) {
    const auto left = position.row(row_of(k));
    const auto right = position.row(row_of(k + 1));
    const double x = position(point, 0);
    if (x < left.x() || x >= right.x()) continue;
    const double slope = (right.y() - left.y()) / (right.x() - left.x());
    return Below{slope, position(point, 1) - left.y() - slope * (x - left.x())};
  }
  return std::nullopt;
}

double potential_by_search(const PointArray& position, GapMeasure measure) {
  double energy = 0.0;
  for (Eigen::Index i = 0; i < kDiskPoints; ++i) {
    const auto bond = below(position, i);
    if (bond && bond->gap(measure) < kThreshold) energy += kLaw.potential_at(bond->gap(measure));
  }
  return energy;
}

class EveryMeasure : public testing::TestWithParam<GapMeasure> {};

TEST_P(EveryMeasure, ForcesSumToZero) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const PointArray position = random_configuration(seed);
    SurfaceContact wall = wall_at(position, GetParam());
    const PointArray force = forces(wall, position);
    ASSERT_GT(wall.total_force().y(), 0.1);
    // Rounding of sums of forces of order 1.
    EXPECT_NEAR(force.col(0).sum(), 0.0, 1e-13);
    EXPECT_NEAR(force.col(1).sum(), 0.0, 1e-13);
    EXPECT_NEAR(force.col(0).head(kDiskPoints).sum(), wall.total_force().x(), 1e-13);
    EXPECT_NEAR(force.col(1).head(kDiskPoints).sum(), wall.total_force().y(), 1e-13);
  }
}

/// None for the normal gap; slope times gap times force for the vertical one.
TEST_P(EveryMeasure, HasTheDocumentedTorque) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const PointArray position = random_configuration(seed);
    SurfaceContact wall = wall_at(position, GetParam());
    double expected = 0.0;
    for (Eigen::Index i = 0; i < kDiskPoints && GetParam() == GapMeasure::kVertical; ++i) {
      const auto bond = below(position, i);
      if (!bond || bond->vertical_gap >= kThreshold) continue;
      expected += bond->slope * bond->vertical_gap * kLaw.force_at(bond->vertical_gap);
    }
    // Rounding of sums of forces of order 1 at arms of up to 6.
    EXPECT_NEAR(torque(position, forces(wall, position)), expected, 1e-12);
  }
}

TEST_P(EveryMeasure, ForceIsMinusTheGradientOfThePotential) {
  const PointArray position = random_configuration(7);
  SurfaceContact wall = wall_at(position, GetParam());
  const PointArray force = forces(wall, position);
  constexpr double kStep = 1e-5;
  for (Eigen::Index k = 0; k < position.size(); ++k) {
    const auto potential = [&](double shift) {
      PointArray moved = position;
      moved.data()[k] += shift;
      return wall.potential_energy(moved);
    };
    const double slope = (potential(-kStep) - potential(kStep)) / (2.0 * kStep);
    // Central differences of energies of order 1: truncation of order (a step)² = 10⁻⁸ of forces
    // up to 10, rounding of order 10⁻¹⁶/step.
    EXPECT_NEAR(force.data()[k], slope, 1e-7) << k;
  }
}

/// Points that swing from beside the wall on the left to beside it on the right, out of reach and
/// back, passing up to three bonds between two looks.
TEST_P(EveryMeasure, FindsTheBondBelowAlongTheWay) {
  const PointArray start = random_configuration(3);
  SurfaceContact wall = wall_at(start, GetParam());
  int in_reach = 0;
  for (int look = 0; look < 400; ++look) {
    PointArray position = start;
    for (Eigen::Index i = 0; i < kDiskPoints; ++i) {
      const double phase = 0.4 * look + static_cast<double>(i);
      position(i, 0) = 3.0 + 4.0 * std::sin(phase);
      position(i, 1) = 0.4 + 0.5 * std::sin(0.73 * phase);
    }
    forces(wall, position);
    const double expected = potential_by_search(position, GetParam());
    // Rounding of gaps of order 1, a = 10 times as large in the exponent.
    EXPECT_NEAR(wall.potential_energy(position), expected, 1e-13 * std::max(1.0, expected));
    in_reach += static_cast<int>(wall.contacts(position, 0.0).size());
  }
  EXPECT_GT(in_reach, 1000);
  EXPECT_LT(in_reach, 400 * kDiskPoints / 2 + 1000);
}

TEST_P(EveryMeasure, CountsNoHopsWhileTheBondsStay) {
  const PointArray position = random_configuration(5);
  SurfaceContact wall = wall_at(position, GetParam());
  ASSERT_GT(wall.potential_energy(position), 0.0);
  forces(wall, position);
  EXPECT_EQ(wall.hops(), 0.0);
  EXPECT_EQ(wall.hops_size(), 0.0);
}

/// Two bonds that meet in a valley at (1, 0), with slopes −s and s, and one point above.
PointArray valley(double x, double y, double slope = 0.5) {
  PointArray position(4, 2);
  position << x, y, 0.0, slope, 1.0, 0.0, 2.0, slope;
  return position;
}

SurfaceContact valley_wall(const PointArray& position, GapMeasure measure) {
  return SurfaceContact(kLaw, kThreshold, measure, {0}, {1, 2, 3}, position);
}

TEST_P(EveryMeasure, FarFromTheWallOrBesideItNothingIsFelt) {
  const double lift = GetParam() == GapMeasure::kVertical ? 1.0 : std::sqrt(1.25);
  SurfaceContact wall = valley_wall(valley(0.5, 3.0), GetParam());
  const auto felt = [&](double x, double y) {
    return forces(wall, valley(x, y)).abs().maxCoeff() > 0.0;
  };
  EXPECT_TRUE(felt(0.5, 0.25 + 0.999 * kThreshold * lift));
  EXPECT_FALSE(felt(0.5, 0.25 + 1.001 * kThreshold * lift));
  EXPECT_TRUE(felt(0.001, 0.55));
  EXPECT_FALSE(felt(-0.001, 0.55));
  EXPECT_TRUE(felt(1.999, 0.55));
  EXPECT_FALSE(felt(2.001, 0.55));
  EXPECT_EQ(wall.potential_energy(valley(2.001, 0.55)), 0.0);
  EXPECT_EQ(wall.largest_force(), 0.0);
  EXPECT_TRUE(wall.contacts(valley(2.001, 0.55), 0.0).empty());
  EXPECT_TRUE(wall.reactions(valley(2.001, 0.55), 0.0).empty());
}

/// In a motion that has broken down, until that is noticed.
TEST_P(EveryMeasure, APointThatIsNowhereIsAboveNoBond) {
  SurfaceContact wall = valley_wall(valley(0.5, 0.4), GetParam());
  const double nowhere = std::nan("");
  EXPECT_EQ(forces(wall, valley(nowhere, nowhere)).abs().maxCoeff(), 0.0);
  EXPECT_TRUE(wall.contacts(valley(nowhere, nowhere), 0.0).empty());
}

/// On a slope of 1.5 the vertical gap is 1.8 times the normal one; the whole of it is felt.
TEST_P(EveryMeasure, ReachesAsFarOnASteepSlope) {
  const double lift = GetParam() == GapMeasure::kVertical ? 1.0 : std::sqrt(1.0 + 1.5 * 1.5);
  SurfaceContact wall = valley_wall(valley(1.99, 9.0, 1.5), GetParam());
  const double surface = 0.99 * 1.5;
  const auto felt = [&](double height) {
    return forces(wall, valley(1.99, surface + height, 1.5)).abs().maxCoeff() > 0.0;
  };
  EXPECT_TRUE(felt(0.999 * kThreshold * lift));
  EXPECT_FALSE(felt(1.001 * kThreshold * lift));
}

/// Into reach and out again at the side: what appears and vanishes is counted.
TEST_P(EveryMeasure, CountsWhatEntersAndLeavesItsReach) {
  SurfaceContact wall = valley_wall(valley(-0.1, 0.4), GetParam());
  EXPECT_EQ(wall.hops(), 0.0);
  forces(wall, valley(0.25, 0.4));
  const double entered = wall.potential_energy(valley(0.25, 0.4));
  EXPECT_GT(entered, 0.0);
  EXPECT_DOUBLE_EQ(wall.hops(), entered);
  const double left = wall.potential_energy(valley(-0.1, 0.5));
  forces(wall, valley(-0.1, 0.5));
  EXPECT_DOUBLE_EQ(wall.hops(), entered - left);
  EXPECT_DOUBLE_EQ(wall.hops_size(), entered + left);
}

/// Evaluations at the stages of an integrator, here one past the valley and one out of reach.
TEST_P(EveryMeasure, CountsNoHopsOfExcursionsBetweenCounts) {
  const PointArray position = valley(0.5, 0.5);
  SurfaceContact wall = valley_wall(position, GetParam());
  PointArray force = PointArray::Zero(4, 2);
  wall.add_forces(valley(1.5, 0.4), force);
  wall.add_forces(valley(0.5, 3.0), force);
  wall.add_forces(position, force);
  wall.count_hops(position);
  EXPECT_GT(wall.potential_energy(position), 0.0);
  EXPECT_EQ(wall.hops_size(), 0.0);
  wall.add_forces(valley(0.5, 3.0), force);
  wall.count_hops(valley(0.5, 3.0));
  EXPECT_GT(wall.hops_size(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(GapMeasure, EveryMeasure,
                         testing::Values(GapMeasure::kNormal, GapMeasure::kVertical));

/// From the slope −1/2 to the slope 1 the normal gap of a point at height y above the common end
/// jumps from y/√1.25 to y/√2, the vertical gap not at all.
TEST(Hop, HasTheEnergyBetweenTheTwoBonds) {
  const auto at = [](double x) {
    PointArray position = valley(x, 0.2);
    position(3, 1) = 1.0;
    return position;
  };
  SurfaceContact normal = valley_wall(at(0.9), GapMeasure::kNormal);
  SurfaceContact vertical = valley_wall(at(0.9), GapMeasure::kVertical);
  forces(normal, at(1.0));
  forces(vertical, at(1.0));
  const double jump =
      kLaw.potential_at(0.2 / std::sqrt(2.0)) - kLaw.potential_at(0.2 / std::sqrt(1.25));
  EXPECT_NEAR(normal.hops(), jump, 1e-16);
  EXPECT_NEAR(normal.hops_size(), std::abs(jump), 1e-16);
  EXPECT_GT(std::abs(jump), 1e-3);
  EXPECT_NEAR(vertical.hops_size(), 0.0, 1e-16);

  const Eigen::Vector2d before = Eigen::Vector2d(0.5, 1.0).normalized();
  const Eigen::Vector2d after = Eigen::Vector2d(-1.0, 1.0).normalized();
  EXPECT_NEAR(normal.turned(), kLaw.potential_at(0.2 / std::sqrt(2.0)) * (after - before).norm(),
              1e-15);
  EXPECT_NEAR(vertical.turned(), kLaw.potential_at(0.2) * 1.5, 1e-15);
}

/// Two points beside a level surface, one at each side, as if it went on.
TEST(EnergyBeside, IsThatOfALongerWall) {
  PointArray position = PointArray::Zero(kDiskPoints + kSurfacePoints, 2);
  for (int k = 0; k < kSurfacePoints; ++k) position(row_of(k), 0) = k;
  position.col(0).head(kDiskPoints) = 3.0;
  const auto energy = [&] {
    return wall_at(position, GapMeasure::kNormal).energy_beside(position);
  };
  EXPECT_EQ(energy(), 0.0);
  position.row(0) << -0.5, 0.1;
  position.row(1) << 6.5, -0.2;
  EXPECT_DOUBLE_EQ(energy(), kLaw.potential_at(0.1) + kLaw.potential_at(-0.2));
}

TEST(Contacts, AndReactionsAreOpposite) {
  for (const GapMeasure measure : {GapMeasure::kNormal, GapMeasure::kVertical}) {
    const PointArray position = random_configuration(11);
    SurfaceContact wall = wall_at(position, measure);
    const PointArray force = forces(wall, position);
    Eigen::Array2d on_disk = Eigen::Array2d::Zero();
    for (const PointForce& contact : wall.contacts(position, 0.0)) {
      on_disk += contact.force;
      const auto there = force.row(contact.point).transpose();
      EXPECT_LT((contact.force - there).abs().maxCoeff(), 1e-14);
    }
    Eigen::Array2d on_wall = Eigen::Array2d::Zero();
    for (const PointForce& reaction : wall.reactions(position, 0.0)) {
      on_wall += reaction.force;
      const auto there = force.row(reaction.point).transpose();
      EXPECT_LT((reaction.force - there).abs().maxCoeff(), 1e-13);
    }
    // Rounding of sums of forces of order 1.
    EXPECT_LT((on_disk - wall.total_force()).abs().maxCoeff(), 1e-13);
    EXPECT_LT((on_disk + on_wall).abs().maxCoeff(), 1e-13);
  }
}

TEST(Contacts, ListOnlyForcesAboveTheLeast) {
  const PointArray position = random_configuration(11);
  SurfaceContact wall = wall_at(position, GapMeasure::kNormal);
  forces(wall, position);
  const auto all = wall.contacts(position, 0.0);
  const auto strong = wall.contacts(position, 0.5 * wall.largest_force());
  EXPECT_GT(strong.size(), 0U);
  EXPECT_LT(strong.size(), all.size());
  EXPECT_TRUE(wall.contacts(position, wall.largest_force()).empty());
  EXPECT_TRUE(wall.reactions(position, wall.largest_force()).empty());
}

}  // namespace
}  // namespace impact
