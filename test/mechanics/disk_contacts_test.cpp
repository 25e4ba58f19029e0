#include "mechanics/disk_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace impact {
namespace {

constexpr std::int32_t kCornersOfOctagon = 8;
constexpr double kReachOfRow = 0.5;
const Repulsion kRepulsionOfRow(20.0, 0.1);

/// Three octagons of radius 1 in a triangle, each within reach of both others.
PointArray three_outlines() {
  const double centres[3][2] = {{0.0, 0.0}, {2.1, 0.05}, {1.0, -1.85}};
  PointArray position(3 * kCornersOfOctagon, 2);
  for (int body = 0; body < 3; ++body) {
    for (int k = 0; k < kCornersOfOctagon; ++k) {
      const double angle = 2.0 * M_PI * (k + 0.3 * body) / kCornersOfOctagon;
      position.row(body * kCornersOfOctagon + k) << centres[body][0] + std::cos(angle),
          centres[body][1] + std::sin(angle);
    }
  }
  return position;
}

/// Clockwise and closed.
std::vector<std::int32_t> octagon(std::int32_t body) {
  std::vector<std::int32_t> rows;
  for (std::int32_t k = kCornersOfOctagon; k >= 0; --k)
    rows.push_back(body * kCornersOfOctagon + k % kCornersOfOctagon);
  return rows;
}

DiskContacts contacts_at(const PointArray& position) {
  return DiskContacts(kRepulsionOfRow, kReachOfRow, {octagon(0), octagon(1), octagon(2)}, position);
}

PointArray forces_between(DiskContacts& contacts, const PointArray& position) {
  PointArray force = PointArray::Zero(position.rows(), 2);
  contacts.add_forces(position, force);
  return force;
}

TEST(DiskContacts, ForcesAreTheGradientOfTheEnergy) {
  const PointArray position = three_outlines();
  DiskContacts contacts = contacts_at(position);
  const PointArray force = forces_between(contacts, position);
  constexpr double kShift = 1e-6;
  const auto energy_at = [&](const PointArray& shifted) {
    forces_between(contacts, shifted);
    return contacts.potential_energy(shifted);
  };
  for (Eigen::Index i = 0; i < position.rows(); ++i) {
    for (const int axis : {0, 1}) {
      PointArray low = position;
      PointArray high = position;
      low(i, axis) -= kShift;
      high(i, axis) += kShift;
      const double slope = (energy_at(high) - energy_at(low)) / (2.0 * kShift);
      // The central difference errs by a² F h²/6, 10⁻¹⁰ of F, and by rounding over h.
      EXPECT_NEAR(force(i, axis), -slope, 1e-8) << i << " " << axis;
    }
  }
}

TEST(DiskContacts, AreOneOfEveryTwoBodies) {
  const PointArray position = three_outlines();
  DiskContacts contacts = contacts_at(position);
  forces_between(contacts, position);
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i + 1; j < 3; ++j) {
      DiskContact pair(kRepulsionOfRow, kReachOfRow, octagon(static_cast<std::int32_t>(i)),
                       octagon(static_cast<std::int32_t>(j)), position);
      EXPECT_EQ(contacts.potential_energy(i, j, position), pair.potential_energy(position));
      EXPECT_EQ(contacts.potential_energy(j, i, position), pair.potential_energy(position));
      EXPECT_GT(pair.potential_energy(position), 1e-5);
      sum += pair.potential_energy(position);
    }
  }
  EXPECT_NEAR(contacts.potential_energy(position), sum, 1e-16);
}

/// On each body the listed forces, those of its rows and the total are the same; all together are
/// nothing.
TEST(DiskContacts, ListTheForcesOnEachBody) {
  const PointArray position = three_outlines();
  DiskContacts contacts = contacts_at(position);
  const PointArray force = forces_between(contacts, position);
  PointArray listed = PointArray::Zero(position.rows(), 2);
  Eigen::Array2d all = Eigen::Array2d::Zero();
  for (std::size_t body = 0; body < 3; ++body) {
    Eigen::Array2d total = Eigen::Array2d::Zero();
    for (const PointForce& on : contacts.forces_on(body, position, 0.0)) {
      listed.row(on.point) += on.force.transpose();
      total += on.force;
    }
    EXPECT_LT((total - contacts.total_force_on(body)).abs().maxCoeff(), 1e-15);
    EXPECT_GT(total.abs().maxCoeff(), 1e-3);
    all += total;
  }
  EXPECT_LT((listed - force).abs().maxCoeff(), 1e-15);
  EXPECT_LT(all.abs().maxCoeff(), 1e-15);
  EXPECT_TRUE((contacts.total_force() == contacts.total_force_on(0)).all());
}

/// The stiffest contact counts, whichever it is.
TEST(DiskContacts, KnowTheLargestForceOfAll) {
  PointArray position = three_outlines();
  position.topRows(kCornersOfOctagon).col(0) -= 10.0;
  DiskContacts contacts = contacts_at(position);
  const PointArray force = forces_between(contacts, position);
  EXPECT_EQ(force.topRows(kCornersOfOctagon).abs().maxCoeff(), 0.0);
  EXPECT_GT(contacts.largest_force(), 1e-3);
}

}  // namespace
}  // namespace impact
