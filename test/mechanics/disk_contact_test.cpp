#include "mechanics/disk_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "test_lattices.hpp"

namespace impact {
namespace {

constexpr int kFirst = 14;   // points of the outline
constexpr int kSecond = 23;  // of a larger one
constexpr double kReach = 0.5;
const Repulsion kRepulsion(10.0, 0.1);

using Rows = std::vector<std::int32_t>;

/// Clockwise, the first one again at the end.
Rows outline(int first_row, int points) {
  Rows rows;
  for (int k = 0; k <= points; ++k) rows.push_back(first_row + (points - k) % points);
  return rows;
}
Rows first_outline() { return outline(0, kFirst); }
Rows second_outline() { return outline(kFirst, kSecond); }

/// A circle of radius 1 over one of radius 1.6 about the origin, the points of both off their
/// places by up to `roughness`.
PointArray two_outlines(double distance, double direction, double roughness, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> off(-roughness, roughness);
  PointArray position(kFirst + kSecond, 2);
  const auto place = [&](int row, double angle, double radius) {
    position.row(row) << radius * std::cos(angle) + off(random),
        radius * std::sin(angle) + off(random);
  };
  for (int k = 0; k < kFirst; ++k) place(k, 2.0 * M_PI * k / kFirst + 0.1, 1.0);
  for (int k = 0; k < kSecond; ++k) place(kFirst + k, 2.0 * M_PI * k / kSecond, 1.6);
  position.topRows(kFirst).rowwise() +=
      distance * Eigen::Array2d(std::cos(direction), std::sin(direction)).transpose();
  return position;
}

DiskContact contact_at(const PointArray& position) {
  return DiskContact(kRepulsion, kReach, first_outline(), second_outline(), position);
}

PointArray forces_of(DiskContact& contact, const PointArray& position) {
  PointArray force = PointArray::Zero(position.rows(), 2);
  contact.add_forces(position, force);
  return force;
}

/// Distance of a point from a polygon, negative inside, by looking at every side and counting the
/// crossings of a ray.
double signed_distance(const PointArray& position, int point, int first_row, int points) {
  double least = 1e9;
  bool inside = false;
  const Eigen::Array2d p = position.row(point).transpose();
  for (int k = 0; k < points; ++k) {
    const Eigen::Array2d a = position.row(first_row + k).transpose();
    const Eigen::Array2d b = position.row(first_row + (k + 1) % points).transpose();
    const double foot = ((p - a) * (b - a)).sum() / (b - a).square().sum();
    const Eigen::Array2d nearest = a + std::fmin(1.0, std::fmax(0.0, foot)) * (b - a);
    least = std::fmin(least, (p - nearest).matrix().norm());
    const bool crosses = (a.y() > p.y()) != (b.y() > p.y());
    if (crosses && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
      inside = !inside;
    }
  }
  return inside ? -least : least;
}

double energy_by_search(const PointArray& position) {
  double energy = 0.0;
  const auto add = [&](int point, int first_row, int points) {
    const double gap = signed_distance(position, point, first_row, points);
    if (gap < kReach) energy += kRepulsion.potential_at(gap);
  };
  for (int k = 0; k < kFirst; ++k) add(k, kFirst, kSecond);
  for (int k = 0; k < kSecond; ++k) add(kFirst + k, 0, kFirst);
  return energy;
}

TEST(DiskContact, FindsTheNearestPlacesOfBothOutlines) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const PointArray position = two_outlines(2.5 + 0.01 * seed, 0.7 * seed, 0.05, seed);
    const double energy = energy_by_search(position);
    EXPECT_NEAR(contact_at(position).potential_energy(position), energy, 1e-12 * energy) << seed;
  }
}

/// The walk along the outline finds what a search finds, however the disks roll on each other.
TEST(DiskContact, FollowsThePointsAround) {
  DiskContact contact = contact_at(two_outlines(2.55, 0.0, 0.02, 1));
  for (double angle = 0.0; angle < 7.0; angle += 0.05) {
    const PointArray position = two_outlines(2.55, angle, 0.02, 1);
    forces_of(contact, position);
    const double energy = energy_by_search(position);
    EXPECT_NEAR(contact.potential_energy(position), energy, 1e-12 * energy) << angle;
  }
}

/// A point beyond a sharp corner lies on the inner side of one bond's line, and yet outside.
TEST(DiskContact, IsOutsideBeyondASharpCorner) {
  PointArray position(6, 2);
  for (double x = -0.2; x <= 0.2; x += 0.01) {
    // Needles of an angle of 17°, tip beside tip.
    position << x - 0.3, 2.1, x + 0.3, 2.1, x, 0.1, -0.3, -2.0, 0.3, -2.0, 0.0, 0.0;
    DiskContact contact(kRepulsion, kReach, {0, 1, 2, 0}, {3, 5, 4, 3}, position);
    const double gap = std::hypot(x, 0.1);
    EXPECT_NEAR(contact.potential_energy(position), 2.0 * kRepulsion.potential_at(gap), 1e-12) << x;
  }
}

TEST(DiskContact, ForcesAreTheGradientOfTheEnergy) {
  constexpr double kStep = 1e-6;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const PointArray position = two_outlines(2.5 + 0.02 * seed, 1.3 * seed, 0.05, seed);
    DiskContact contact = contact_at(position);
    const PointArray force = forces_of(contact, position);
    for (Eigen::Index i = 0; i < position.rows(); ++i) {
      for (int axis = 0; axis < 2; ++axis) {
        const auto energy_at = [&](double shift) {
          PointArray moved = position;
          moved(i, axis) += shift;
          return energy_by_search(moved);
        };
        const double slope = (energy_at(kStep) - energy_at(-kStep)) / (2.0 * kStep);
        // a² F kStep²/6 of the difference, and rounding of the energies over kStep.
        EXPECT_NEAR(force(i, axis), -slope, 1e-8) << seed << " " << i;
      }
    }
  }
}

TEST(DiskContact, KeepsMomentumAndAngularMomentum) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const PointArray position = two_outlines(2.45 + 0.01 * seed, seed, 0.08, seed);
    DiskContact contact = contact_at(position);
    const PointArray force = forces_of(contact, position);
    const double size = force.abs().sum();
    ASSERT_GT(size, 0.0);
    const double torque = (position.col(0) * force.col(1) - position.col(1) * force.col(0)).sum();
    // Rounding of sums of some forty terms.
    EXPECT_LT(force.colwise().sum().abs().maxCoeff(), 1e-14 * size);
    EXPECT_LT(std::abs(torque), 1e-14 * size);
    EXPECT_LT((contact.total_force().transpose() - force.topRows(kFirst).colwise().sum())
                  .abs()
                  .maxCoeff(),
              1e-14 * size);
  }
}

TEST(DiskContact, TellsTheDisksApartByNothing) {
  const PointArray position = two_outlines(2.5, 0.4, 0.05, 3);
  DiskContact contact = contact_at(position);
  DiskContact exchanged(kRepulsion, kReach, second_outline(), first_outline(), position);
  const PointArray difference = forces_of(contact, position) - forces_of(exchanged, position);
  EXPECT_LT(difference.abs().maxCoeff(), 1e-15);
  EXPECT_LT((contact.total_force() + exchanged.total_force()).abs().maxCoeff(), 1e-14);
  EXPECT_EQ(contact.potential_energy(position), exchanged.potential_energy(position));
}

TEST(DiskContact, IsNotFeltBeyondItsThreshold) {
  const double apart = 1.0 + 1.6 + kReach;
  const PointArray beyond = two_outlines(apart + 1e-6, 0.4, 0.0, 1);
  DiskContact contact = contact_at(beyond);
  EXPECT_EQ(forces_of(contact, beyond).abs().maxCoeff(), 0.0);
  EXPECT_EQ(contact.potential_energy(beyond), 0.0);
}

/// Where outlines are convex the gap is continuous, and so is its gradient: nothing hops or turns,
/// however the one disk slides around the other. Only the number of points that are within the
/// threshold changes, each by exp(−a threshold) of V₀, 4·10⁻¹⁸.
TEST(DiskContact, HasNoHopsOnConvexOutlines) {
  constexpr double kStep = 1e-4;
  DiskContact contact(Repulsion(80.0, 0.1), kReach, first_outline(), second_outline(),
                      two_outlines(2.6, 0.0, 0.0, 1));
  double energy = 0.0;
  for (double angle = kStep; angle < 1.0; angle += kStep) {
    const PointArray position = two_outlines(2.6, angle, 0.0, 1);
    forces_of(contact, position);
    contact.count_hops(position);
    energy = std::fmax(energy, contact.potential_energy(position));
  }
  EXPECT_GT(contact.hops_size(), 0.0);
  EXPECT_LT(contact.hops_size(), 1e-14 * energy);
  EXPECT_EQ(contact.turned(), 0.0);
}

/// A triangle with its tip at x, y over a square with a dent in its top: the corner of the dent is
/// at the origin, its sides have the slopes 0.3 and −0.3.
PointArray tip_over_dent(double x, double y) {
  PointArray position(8, 2);
  position << -0.1, 0.7, 0.1, 0.7, x, y, -1.0, -1.0, 1.0, -1.0, 1.0, 0.3, 0.0, 0.0, -1.0, 0.3;
  return position;
}
const Rows kTriangle{0, 1, 2, 0};
const Rows kDentedSquare{3, 7, 6, 5, 4, 3};

/// The nearest place of the square is the corner, which lies in the triangle. From its side it is
/// as far as the sine of half of the angle at the tip says, and the cosine is how far from the tip.
TEST(DiskContact, IsInsideUnderADent) {
  constexpr double kDeep = 0.05;
  const PointArray position = tip_over_dent(0.0, -kDeep);
  DiskContact contact(kRepulsion, kReach, kTriangle, kDentedSquare, position);
  const double side = std::hypot(0.1, 0.7 + kDeep);
  const double sine = 0.1 / side;
  const double cosine = (0.7 + kDeep) / side;
  EXPECT_NEAR(contact.potential_energy(position),
              kRepulsion.potential_at(-kDeep) + kRepulsion.potential_at(-kDeep * sine), 1e-12);
  const double of_tip = 1.0 - kDeep * cosine / side;
  EXPECT_NEAR(forces_of(contact, position)(2, 1),
              kRepulsion.force_at(-kDeep) + of_tip * sine * kRepulsion.force_at(-kDeep * sine),
              1e-12);
}

/// A point in a dent goes to and fro between the two bonds that it touches alike.
TEST(DiskContact, CountsOnceWhatChattersInADent) {
  DiskContact contact(kRepulsion, kReach, kTriangle, kDentedSquare, tip_over_dent(-0.01, 0.12));
  DiskContact exchanged(kRepulsion, kReach, kDentedSquare, kTriangle, tip_over_dent(-0.01, 0.12));
  const auto move_to = [&](double x) {
    const PointArray position = tip_over_dent(x, 0.12);
    for (DiskContact* one : {&contact, &exchanged}) {
      forces_of(*one, position);
      one->count_hops(position);
    }
  };
  move_to(0.01);
  const double once = contact.turned();
  EXPECT_NEAR(once, kRepulsion.potential_at(0.117 / std::sqrt(1.09)) * 2.0 * 0.3 / std::sqrt(1.09),
              1e-12);
  for (int k = 0; k < 5; ++k) {
    move_to(-0.01);
    move_to(0.01);
  }
  EXPECT_EQ(contact.turned(), once);
  EXPECT_EQ(exchanged.turned(), once);
  EXPECT_EQ(contact.hops_size(), 0.0);
}

TEST(DiskContact, ListsTheForcesOnBothDisks) {
  const PointArray position = two_outlines(2.5, 0.4, 0.05, 3);
  DiskContact contact = contact_at(position);
  const PointArray force = forces_of(contact, position);
  PointArray listed = PointArray::Zero(position.rows(), 2);
  for (const PointForce& on_first : contact.contacts(position, 0.0)) {
    EXPECT_LT(on_first.point, kFirst);
    listed.row(on_first.point) = on_first.force.transpose();
  }
  for (const PointForce& on_second : contact.reactions(position, 0.0)) {
    EXPECT_GE(on_second.point, kFirst);
    listed.row(on_second.point) = on_second.force.transpose();
  }
  EXPECT_LT((listed - force).abs().maxCoeff(), 1e-14);
}

}  // namespace
}  // namespace impact
