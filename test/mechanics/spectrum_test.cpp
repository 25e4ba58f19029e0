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

/// Against a dense eigensolver.
TEST(Spectrum, OfAPatch) {
  const Lattice lattice = triangular_patch(7);
  const Eigen::Index n = lattice.points.rows();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(n, n);
  for (const Bond& bond : lattice.bonds) {
    const Eigen::Array2d normal = lattice.points.row(bond.second) - lattice.points.row(bond.first);
    Eigen::VectorXd elongation = Eigen::VectorXd::Zero(2 * n);
    elongation(bond.first) = -normal.x();
    elongation(bond.second) = normal.x();
    elongation(n + bond.first) = -normal.y();
    elongation(n + bond.second) = normal.y();
    stiffness += elongation * elongation.transpose();
    Eigen::VectorXd difference = Eigen::VectorXd::Zero(n);
    difference(bond.first) = 1.0;
    difference(bond.second) = -1.0;
    laplacian += difference * difference.transpose();
  }
  const auto largest = [](const Eigen::MatrixXd& matrix) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues().maxCoeff();
  };
  const Spectrum spectrum = lattice_spectrum(lattice, {1.0, 0.0, 1.0}, 1.0);
  expect_bound(spectrum.omega_squared, largest(stiffness));
  expect_bound(spectrum.gamma, largest(laplacian));
}

}  // namespace
}  // namespace impact
