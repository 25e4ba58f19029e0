#include "mechanics/spectrum.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "test_lattices.hpp"

namespace impact {
namespace {

/// The documented margin of the bound.
void expect_bound(double bound, double exact) {
  EXPECT_GE(bound, exact);
  EXPECT_LE(bound, 1.005 * exact);
}

/// Two points: ω² = 2 k_a/m and γ = 2 η/m.
TEST(Spectrum, OfTwoPoints) {
  const Spectrum spectrum = lattice_spectrum(two_points(), {1.5, 0.0, 0.25}, 0.5);
  expect_bound(spectrum.omega_squared, 6.0);
  expect_bound(spectrum.gamma, 1.0);
}

/// Triangle: breathing at ω² = 3 k_a/m (the other two modes: 3 k_a/(2m)); Laplacian 0, 3, 3.
TEST(Spectrum, OfATriangle) {
  const Spectrum spectrum = lattice_spectrum(triangle(), {1.0, 0.0, 1.0}, 1.0);
  expect_bound(spectrum.omega_squared, 3.0);
  expect_bound(spectrum.gamma, 3.0);
}

TEST(Spectrum, WithoutDampingHasNoDampingRate) {
  EXPECT_EQ(lattice_spectrum(triangle(), {1.0, 0.0, 0.0}, 1.0).gamma, 0.0);
}

/// k_a = 1, bonds of length 1.
Eigen::MatrixXd stiffness_of(const Lattice& lattice) {
  const Eigen::Index n = lattice.points.rows();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  for (const Bond& bond : lattice.bonds) {
    const Eigen::Array2d normal = lattice.points.row(bond.second) - lattice.points.row(bond.first);
    Eigen::VectorXd elongation = Eigen::VectorXd::Zero(2 * n);
    elongation(bond.first) = -normal.x();
    elongation(bond.second) = normal.x();
    elongation(n + bond.first) = -normal.y();
    elongation(n + bond.second) = normal.y();
    stiffness += elongation * elongation.transpose();
  }
  return stiffness;
}

double largest(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues().maxCoeff();
}

/// Against a dense eigensolver.
TEST(Spectrum, OfAPatch) {
  const Lattice lattice = triangular_patch(7);
  const Eigen::Index n = lattice.points.rows();
  Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(n, n);
  for (const Bond& bond : lattice.bonds) {
    Eigen::VectorXd difference = Eigen::VectorXd::Zero(n);
    difference(bond.first) = 1.0;
    difference(bond.second) = -1.0;
    laplacian += difference * difference.transpose();
  }
  const Spectrum spectrum = lattice_spectrum(lattice, {1.0, 0.0, 1.0}, 1.0);
  expect_bound(spectrum.omega_squared, largest(stiffness_of(lattice)));
  expect_bound(spectrum.gamma, largest(laplacian));
}

/// The lowest row of a patch presses on a wall, as stiff on each of its points as is allowed or
/// less; the row above meets a part of it. The bound is within 1.3 times it, where adding the rate
/// to the lattice's own is up to 1.5 times too much.
TEST(Spectrum, BoundsWhatContactsAdd) {
  const Lattice lattice = triangular_patch(7);
  const Eigen::Index n = lattice.points.rows();
  std::vector<std::int32_t> lowest;
  for (std::int32_t i = 0; i < n; ++i) {
    if (lattice.points(i, 1) < 0.5) lowest.push_back(i);
  }
  ASSERT_EQ(lowest.size(), 7U);
  const double mass = 0.5;
  const Spectrum spectrum = lattice_spectrum(lattice, {3.0, 0.0, 0.0}, mass, lowest);
  const Spectrum unknown = lattice_spectrum(lattice, {3.0, 0.0, 0.0}, mass);
  for (const double times : {0.0, 0.1, 0.3, 0.45, 0.7, 1.0, 3.0}) {
    for (const double inner_share : {0.0, 0.2}) {
      const double rate = times * spectrum.omega_squared;
      Eigen::MatrixXd all = 3.0 / mass * stiffness_of(lattice);
      for (Eigen::Index i = 0; i < n; ++i) {
        const bool is_lowest = lattice.points(i, 1) < 0.5;
        all(n + i, n + i) += is_lowest                    ? rate
                             : lattice.points(i, 1) < 1.0 ? inner_share * rate
                                                          : 0.0;
      }
      const double bound = spectrum.with_contacts(rate, inner_share);
      EXPECT_GE(bound, largest(all)) << times << " " << inner_share;
      EXPECT_LE(bound, spectrum.omega_squared + rate) << times << " " << inner_share;
      EXPECT_LE(bound, 1.3 * largest(all)) << times << " " << inner_share;
      EXPECT_DOUBLE_EQ(unknown.with_contacts(rate, inner_share), unknown.omega_squared + rate);
    }
  }
}

/// Where bonds lie so evenly about an outer point that they have no outside.
TEST(Spectrum, IsFiniteWhereBondsCancel) {
  PointArray points(5, 2);
  points << 0, 0, 1, 0, -1, 0, 0, 1, 0, -1;
  const Lattice cross = plain_lattice(points, {{0, 1}, {0, 2}, {0, 3}, {0, 4}});
  const Spectrum spectrum = lattice_spectrum(cross, {1.0, 0.0, 0.0}, 1.0, {0, 1, 2, 3, 4});
  EXPECT_GT(spectrum.stiffened, spectrum.omega_squared);
  EXPECT_LT(spectrum.stiffened, 2.0 * spectrum.omega_squared);
}

}  // namespace
}  // namespace impact
