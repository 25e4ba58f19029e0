#include "mechanics/spectrum.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>
#include <vector>

namespace impact {
namespace {

using Vector = Eigen::VectorXd;

constexpr int kMostLanczosSteps = 300;
constexpr int kLookInterval = 10;    // iterations
constexpr double kTolerance = 1e-5;  // growth of the Ritz value between two looks
constexpr double kMargin = 2e-3;
constexpr double kBreakdown = 1e-13;

Vector random_unit_vector(Eigen::Index size) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  Vector vector(size);
  for (Eigen::Index i = 0; i < size; ++i) vector(i) = normal(random);
  return vector.normalized();
}

double largest_ritz_value(const std::vector<double>& diagonal,
                          const std::vector<double>& off_diagonal) {
  const auto size = static_cast<Eigen::Index>(diagonal.size());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(Eigen::Map<const Vector>(diagonal.data(), size),
                                Eigen::Map<const Vector>(off_diagonal.data(), size - 1),
                                Eigen::EigenvaluesOnly);
  return solver.eigenvalues()(size - 1);
}

/// Upper bound of the largest eigenvalue of a symmetric positive semi-definite operator
/// `multiply(in, out)`.
template <class Multiply>
double largest_eigenvalue(Eigen::Index size, const Multiply& multiply) {
  Vector current = random_unit_vector(size);
  Vector previous = Vector::Zero(size);
  Vector next(size);
  std::vector<double> diagonal;
  std::vector<double> off_diagonal;
  double largest = 0.0;
  for (int k = 1; k <= kMostLanczosSteps; ++k) {
    multiply(current, next);
    if (k > 1) next -= off_diagonal.back() * previous;
    diagonal.push_back(next.dot(current));
    next -= diagonal.back() * current;
    const double beta = next.norm();

    const bool exhausted = beta <= kBreakdown * std::abs(diagonal.front());
    if (exhausted || k % kLookInterval == 0) {
      const double before = largest;
      largest = largest_ritz_value(diagonal, off_diagonal);
      if (exhausted || largest - before <= kTolerance * largest) break;
    }
    off_diagonal.push_back(beta);
    previous.swap(current);
    current = next / beta;
  }
  return largest * (1.0 + kMargin);
}

double largest_stiffness(const Lattice& lattice, double k_a) {
  const Eigen::Index points = lattice.points.rows();
  PointArray direction(static_cast<Eigen::Index>(lattice.bonds.size()), 2);
  for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
    const Bond& bond = lattice.bonds[k];
    direction.row(static_cast<Eigen::Index>(k)) =
        (lattice.points.row(bond.first) - lattice.points.row(bond.second)) /
        lattice.natural_lengths[k];
  }
  return largest_eigenvalue(2 * points, [&](const Vector& in, Vector& out) {
    out.setZero();
    for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
      const Bond& bond = lattice.bonds[k];
      const double nx = direction(static_cast<Eigen::Index>(k), 0);
      const double ny = direction(static_cast<Eigen::Index>(k), 1);
      const double elongation = nx * (in(bond.first) - in(bond.second)) +
                                ny * (in(points + bond.first) - in(points + bond.second));
      const double tension = k_a * elongation;
      out(bond.first) += tension * nx;
      out(bond.second) -= tension * nx;
      out(points + bond.first) += tension * ny;
      out(points + bond.second) -= tension * ny;
    }
  });
}

double largest_laplacian_eigenvalue(const Lattice& lattice) {
  return largest_eigenvalue(lattice.points.rows(), [&](const Vector& in, Vector& out) {
    out.setZero();
    for (const Bond& bond : lattice.bonds) {
      const double difference = in(bond.first) - in(bond.second);
      out(bond.first) += difference;
      out(bond.second) -= difference;
    }
  });
}

}  // namespace

Spectrum lattice_spectrum(const Lattice& lattice, const BondLaw& law, double point_mass) {
  Spectrum spectrum;
  spectrum.omega_squared = largest_stiffness(lattice, law.k_a) / point_mass;
  if (law.eta != 0.0) {
    spectrum.gamma = law.eta * largest_laplacian_eigenvalue(lattice) / point_mass;
  }
  return spectrum;
}

}  // namespace impact
