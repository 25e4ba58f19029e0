#include "reduced/bulk_modes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

#include "mechanics/body_motion.hpp"
#include "mechanics/bond_forces.hpp"
#include "mechanics/force_term.hpp"

namespace impact {
namespace {

constexpr double kDeepest = 0.012;     // R, to which a disk may be pressed in
constexpr double kReachOfWall = 20.0;  // ranges of the wall above that
constexpr double kStatic = 0.01;       // of the largest displacement: the least that a point adds
constexpr double kDamped = 5e-4;       // the same of the damping
constexpr int kBent = 4;
constexpr double kNothingNew = 1e-9;
constexpr int kDistributions = 4;
constexpr int kMoments = 8;
constexpr int kDampedMoments = 3;
constexpr double kDampedScale = 0.2;  // R/c, in which the damping acts
constexpr double kHalfWidth = 0.15;   // R, of the distributions

using Sparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;

Sparse matrix_of(const MatrixEntries& entries, Eigen::Index size) {
  Sparse matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Sparse unit_stiffness(const Lattice& lattice) {
  return matrix_of(BondForces(lattice, {1.0, 0.0, 0.0}).stiffness(lattice.points),
                   2 * lattice.points.rows());
}

/// Along x and along y.
Sparse unit_damping(const Lattice& lattice) {
  const auto n = static_cast<int>(lattice.points.rows());
  MatrixEntries both;
  for (const auto& entry : BondForces(lattice, {1.0, 0.0, 1.0}).damping()) {
    both.push_back(entry);
    both.emplace_back(n + entry.row(), n + entry.col(), entry.value());
  }
  return matrix_of(both, 2 * lattice.points.rows());
}

std::vector<std::int32_t> points_in_reach(const PointArray& arm, double a) {
  const double highest = arm.col(1).minCoeff() + kDeepest + kReachOfWall / a;
  std::vector<std::int32_t> points;
  for (std::int32_t i = 0; i < arm.rows(); ++i) {
    if (arm(i, 1) < highest) points.push_back(i);
  }
  std::stable_sort(points.begin(), points.end(),
                   [&](auto i, auto j) { return arm(i, 1) < arm(j, 1); });
  return points;
}

/// The part of the wall's force that reaches them.
Eigen::ArrayXd weights_of(const PointArray& arm, const std::vector<std::int32_t>& points,
                          double a) {
  const Eigen::ArrayXd height = arm(points, 1);
  return (-a * (height - height.minCoeff() - kDeepest)).exp().min(1.0);
}

/// Orthonormal vectors, to which others are added.
class Subspace {
 public:
  Subspace(Eigen::Index rows, Eigen::Index most) : vectors_(rows, most) {}

  /// Of each of these what the subspace lacks, if that is longer than `least`; made orthogonal
  /// twice for rounding.
  void add(const Eigen::MatrixXd& vectors, double least) {
    for (Eigen::Index k = 0; k < vectors.cols(); ++k) {
      Eigen::VectorXd rest = vectors.col(k);
      const double rounding = kNothingNew * rest.norm();
      for (int twice = 0; twice < 2; ++twice) rest -= present() * (present().transpose() * rest);
      const double length = rest.norm();
      if (length > std::max(least, rounding)) vectors_.col(size_++) = rest / length;
    }
  }
  Eigen::Block<const Eigen::MatrixXd> present() const { return from(0); }
  Eigen::Block<const Eigen::MatrixXd> from(Eigen::Index first) const {
    return vectors_.block(0, first, vectors_.rows(), size_ - first);
  }
  Eigen::Index size() const { return size_; }

 private:
  Eigen::MatrixXd vectors_;
  Eigen::Index size_ = 0;
};

/// What forces in columns do.
Eigen::MatrixXd responses(Compliance& compliance, Eigen::MatrixXd forces) {
  PointArray pair(forces.rows(), 2);
  for (Eigen::Index k = 0; k < forces.cols(); k += 2) {
    const Eigen::Index other = std::min(k + 1, forces.cols() - 1);
    pair.col(0) = forces.col(k).array();
    pair.col(1) = forces.col(other).array();
    compliance.respond(pair);
    forces.col(k) = pair.col(0).matrix();
    forces.col(other) = pair.col(1).matrix();
  }
  return forces;
}

/// Along y, a column for each point.
Eigen::MatrixXd forces_on(const std::vector<std::int32_t>& points, const Eigen::ArrayXd& sizes,
                          Eigen::Index n) {
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(2 * n, sizes.size());
  for (Eigen::Index k = 0; k < sizes.size(); ++k) {
    forces(n + points[static_cast<std::size_t>(k)], k) = sizes(k);
  }
  return forces;
}

/// Powers of the place along the wall.
Eigen::MatrixXd distributions(const PointArray& arm, const std::vector<std::int32_t>& points,
                              const Eigen::ArrayXd& weights) {
  const Eigen::ArrayXd place = arm(points, 0) / kHalfWidth;
  Eigen::MatrixXd powers(weights.size(), kDistributions);
  for (int k = 0; k < kDistributions; ++k) powers.col(k) = place.pow(k).matrix();
  return powers;
}

/// Of the bonds at displacements ±u, in columns: what does not change its sign.
Eigen::MatrixXd even_forces(const Lattice& lattice, const Eigen::MatrixXd& u) {
  const Eigen::Index n = lattice.points.rows();
  BondForces bonds(lattice, {1.0, 0.0, 0.0});
  PointArray position(n, 2);
  PointArray force(n, 2);
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(u.rows(), u.cols());
  for (Eigen::Index k = 0; k < u.cols(); ++k) {
    for (const double sign : {1.0, -1.0}) {
      position.reshaped() = lattice.points.reshaped() + sign * u.col(k).array();
      bonds.evaluate_elastic(position, force);
      forces.col(k) += 0.5 * force.reshaped().matrix();
    }
  }
  return forces;
}

/// Of each of these and of each two of them, as large as the disk may be pressed in.
Eigen::MatrixXd sums_of_two(Eigen::MatrixXd u) {
  for (Eigen::Index k = 0; k < u.cols(); ++k) u.col(k) *= kDeepest / u.col(k).cwiseAbs().maxCoeff();
  Eigen::MatrixXd sums(u.rows(), u.cols() * (u.cols() + 1) / 2);
  Eigen::Index next = 0;
  for (Eigen::Index i = 0; i < u.cols(); ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) sums.col(next++) = 0.5 * (u.col(i) + u.col(j));
  }
  return sums;
}

Eigen::MatrixXd subspace(const Lattice& lattice, Compliance& compliance, const BulkModes& modes,
                         double a) {
  const Eigen::Index n = modes.arm.rows();
  const Eigen::ArrayXd weights = weights_of(modes.arm, modes.points, a);
  Eigen::MatrixXd slow = responses(compliance, forces_on(modes.points, weights, n));
  const double largest = slow.colwise().norm().maxCoeff();
  Subspace space(2 * n, (1 + kDampedMoments) * slow.cols() +
                            Eigen::Index{kDistributions} * (kMoments + kDistributions));
  space.add(slow, kStatic * largest);

  Eigen::MatrixXd swinging = slow * distributions(modes.arm, modes.points, weights);
  const Eigen::MatrixXd bent =
      responses(compliance, even_forces(lattice, sums_of_two(swinging.leftCols(kBent))));
  for (int j = 0; j < kMoments && swinging.cols() > 0; ++j) {
    const Eigen::Index before = space.size();
    space.add(responses(compliance, swinging), 0.0);
    swinging = space.from(before);
  }
  const Sparse damping = unit_damping(lattice);
  for (int j = 0; j < kDampedMoments; ++j) {
    slow = responses(compliance, kDampedScale * (damping * slow));
    space.add(slow, kDamped * largest);
  }
  space.add(bent, 0.0);
  return space.present();
}

/// By 1 rad.
Eigen::VectorXd rotation(const PointArray& arm) {
  Eigen::VectorXd turn(2 * arm.rows());
  turn << -arm.col(1).matrix(), arm.col(0).matrix();
  return turn;
}

}  // namespace

BulkModes bulk_modes(const Lattice& lattice, Compliance& compliance, double a) {
  BulkModes modes;
  modes.arm = about_the_centre(lattice.points);
  modes.points = points_in_reach(modes.arm, a);
  const double point_mass = 1.0 / static_cast<double>(modes.arm.rows());
  const Eigen::VectorXd turn = rotation(modes.arm);
  modes.inertia = point_mass * turn.squaredNorm();

  const Eigen::MatrixXd space = subspace(lattice, compliance, modes, a);
  const Eigen::MatrixXd stiffness =
      PaddedMatrix(space.transpose()) * (unit_stiffness(lattice) * space);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness);
  const Eigen::Index size = 1 + space.cols();
  modes.stiffness = Eigen::VectorXd::Zero(size);
  modes.stiffness.tail(size - 1) = solver.eigenvalues() / point_mass;
  modes.shapes.resize(space.rows(), size);
  modes.shapes.col(0) = turn / std::sqrt(modes.inertia);
  modes.shapes.rightCols(size - 1) =
      PaddedMatrix(space) * (solver.eigenvectors() / std::sqrt(point_mass));
  modes.onto_points = PaddedMatrix(modes.shapes);
  modes.onto_modes = PaddedMatrix(modes.shapes.transpose());
  Eigen::MatrixXd turned(modes.shapes.rows(), size);
  const Eigen::Index n = modes.arm.rows();
  turned << -modes.shapes.bottomRows(n), modes.shapes.topRows(n);
  modes.turning = point_mass * (modes.onto_modes * turned);
  modes.reach = point_mass * (modes.onto_modes * modes.arm.reshaped().matrix());
  modes.damping = modes.onto_modes * (unit_damping(lattice) * modes.shapes);
  return modes;
}

std::shared_ptr<const BulkModes> BulkModesOnDemand::of(const Lattice& lattice,
                                                       ComplianceOnDemand& compliance, double a) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!modes_ || a_ != a) {
    modes_ = std::make_shared<const BulkModes>(bulk_modes(lattice, *compliance.of(lattice), a));
    a_ = a;
  }
  return modes_;
}

}  // namespace impact
