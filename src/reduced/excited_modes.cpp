#include "reduced/excited_modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>

namespace impact {
namespace {

constexpr Eigen::Index kSteps = 12;
constexpr double kExhausted = 1e-12;   // of the first eigenvalue
constexpr double kMostResolved = 1.5;  // rad a step

/// The symmetric tridiagonal matrix that stands for an operator.
struct Tridiagonal {
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(kSteps);
  Eigen::VectorXd beside = Eigen::VectorXd::Zero(kSteps);
  Eigen::Index size = 0;
};

/// The displacements under these forces.
Eigen::VectorXd respond(Compliance& compliance, const Eigen::VectorXd& force) {
  PointArray load = PointArray::Zero(force.size(), 2);
  load.col(0) = force.array();
  compliance.respond(load);
  return load.col(0).matrix();
}

/// Each new vector is made orthogonal to all before it, twice for rounding.
Tridiagonal lanczos(Compliance& compliance, Eigen::VectorXd current) {
  Tridiagonal matrix;
  Eigen::MatrixXd basis(current.size(), kSteps);
  double rest = 1.0;
  while (matrix.size < kSteps && rest > kExhausted * matrix.diagonal(0)) {
    const Eigen::Index k = matrix.size++;
    if (k > 0) matrix.beside(k - 1) = rest;
    basis.col(k) = current;
    Eigen::VectorXd next = respond(compliance, current);
    matrix.diagonal(k) = next.dot(current);
    for (int twice = 0; twice < 2; ++twice) {
      next -= basis.leftCols(k + 1) * (basis.leftCols(k + 1).transpose() * next);
    }
    rest = next.norm();
    current = next / rest;
  }
  return matrix;
}

}  // namespace

std::vector<ExcitedMode> excited_modes(const QuasiStaticContact& contact, double point_mass) {
  PointArray load = PointArray::Zero(2 * contact.arm().rows(), 2);
  load.col(0) = contact.load() / contact.force();
  contact.compliance().balance(load);
  const double norm = load.matrix().col(0).norm();
  const Tridiagonal matrix = lanczos(contact.compliance(), load.col(0).matrix() / norm);
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(matrix.diagonal.head(matrix.size),
                                matrix.beside.head(matrix.size - 1));
  std::vector<ExcitedMode> modes;
  for (Eigen::Index k = 0; k < matrix.size; ++k) {
    const double softness = point_mass * solver.eigenvalues()(k) / contact.k_a();
    const double share = norm * solver.eigenvectors()(0, k);
    modes.push_back({1.0 / std::sqrt(softness), share * share / point_mass});
  }
  return modes;
}

double energy_of_vibrations(const std::vector<ExcitedMode>& modes,
                            const std::vector<double>& forces, double step) {
  double energy = 0.0;
  for (const ExcitedMode& mode : modes) {
    if (!(mode.frequency * step < kMostResolved)) continue;
    const std::complex<double> turn = std::polar(1.0, mode.frequency * step);
    std::complex<double> phase = step;
    std::complex<double> sum = 0.0;
    for (const double force : forces) {
      sum += force * phase;
      phase *= turn;
    }
    energy += 0.5 * mode.weight * std::norm(sum);
  }
  return energy;
}

}  // namespace impact
