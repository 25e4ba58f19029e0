#include "statics/flexibility.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "mechanics/body_motion.hpp"
#include "statics/tied_stiffness.hpp"

namespace impact {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

constexpr Eigen::Index kMostComputed = 150;
constexpr double kTooSoft = 1e8;  // a compliance that only rounding makes finite

/// A unit force on one point along one axis, without what it does to the body as a whole.
Vector balanced_load(const PointArray& arm, Eigen::Index point, int axis) {
  const Eigen::Index n = arm.rows();
  const double moment = axis == 0 ? -arm(point, 1) : arm(point, 0);
  const double turn = moment / arm.square().sum();
  Vector load(2 * n);
  load.head(n) = turn * arm.col(1).matrix();
  load.tail(n) = -turn * arm.col(0).matrix();
  load.segment(axis * n, n).array() -= 1.0 / static_cast<double>(n);
  load(axis * n + point) += 1.0;
  return load;
}

double largest_eigenvalue(double xx, double yy, double xy) {
  return 0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy);
}

/// The largest compliance of a point between neighbours that are held.
double largest_local_compliance(const Lattice& lattice) {
  Eigen::ArrayX3d stiffness = Eigen::ArrayX3d::Zero(lattice.points.rows(), 3);  // xx, yy, xy
  for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
    const Bond& bond = lattice.bonds[k];
    const Eigen::Array2d n = (lattice.points.row(bond.first) - lattice.points.row(bond.second)) /
                             lattice.natural_lengths[k];
    for (const std::int32_t end : {bond.first, bond.second}) {
      stiffness.row(end) += Eigen::Array3d(n.x() * n.x(), n.y() * n.y(), n.x() * n.y()).transpose();
    }
  }
  double largest = 0.0;
  for (const auto& k : stiffness.rowwise()) {
    const double determinant = k(0) * k(1) - k(2) * k(2);
    largest = std::max(largest, largest_eigenvalue(k(1), k(0), -k(2)) / determinant);
  }
  return largest;
}

/// Length over width of the body.
double slenderness(const PointArray& points) {
  const auto moments =
      (about_the_centre(points).matrix().transpose() * about_the_centre(points).matrix()).eval();
  const double major = largest_eigenvalue(moments(0, 0), moments(1, 1), moments(0, 1));
  return std::sqrt(major / (moments.trace() - major));
}

}  // namespace

Flexibility flexibility(const Lattice& lattice) {
  return lattice.points.rows() <= kMostComputed ? computed_flexibility(lattice)
                                                : estimated_flexibility(lattice);
}

Flexibility computed_flexibility(const Lattice& lattice) {
  const PointArray arm = about_the_centre(lattice.points);
  const Eigen::Index n = arm.rows();
  const Eigen::SimplicialLDLT<Matrix> factors(tied_stiffness(lattice));
  if (factors.info() != Eigen::Success) return {};
  double largest = 0.0;
  double trace = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vector along_x = balanced_load(arm, i, 0);
    const Vector along_y = balanced_load(arm, i, 1);
    const Vector response = factors.solve(along_x);
    const double xx = along_x.dot(response);
    const double xy = along_y.dot(response);
    const double yy = along_y.dot(factors.solve(along_y));
    const double compliance = largest_eigenvalue(xx, yy, xy);
    if (!(xx > 0.0 && yy > 0.0 && compliance < kTooSoft)) return {};
    largest = std::max(largest, compliance);
    trace += xx + yy;
  }
  return {largest, std::sqrt(static_cast<double>(n) / trace)};
}

Flexibility estimated_flexibility(const Lattice& lattice) {
  constexpr double kLeastBonds = 2.4;
  constexpr double kLowestFrequency = 2.2;
  const auto points = static_cast<double>(lattice.points.rows());
  if (static_cast<double>(lattice.bonds.size()) < kLeastBonds * points) return {};
  const double slender = std::pow(slenderness(lattice.points), 3);
  return {1.5 + 0.4 * std::log(points) + 3.0 * largest_local_compliance(lattice) +
              0.5 * (slender - 1.0),
          kLowestFrequency / slender};
}

}  // namespace impact
