#include "measure/elastic_constants.hpp"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace impact {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Elongation of each bond per displacement of each point but the first, which is tied; column
/// 2 (i − 1) stands for x of point i, the next for its y.
SparseMatrix elongation_by_displacement(const PeriodicPatch& patch) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * patch.bonds.size());
  const auto add = [&](Eigen::Index bond, std::int32_t point, const Eigen::Vector2d& normal) {
    if (point == 0) return;
    entries.emplace_back(bond, 2 * (point - 1), normal.x());
    entries.emplace_back(bond, 2 * (point - 1) + 1, normal.y());
  };
  for (Eigen::Index k = 0; k < patch.bond_vectors.rows(); ++k) {
    const Bond& bond = patch.bonds[static_cast<std::size_t>(k)];
    const Eigen::Vector2d normal = patch.bond_vectors.row(k).matrix().normalized();
    add(k, bond.first, normal);
    add(k, bond.second, -normal);
  }
  SparseMatrix matrix(patch.bond_vectors.rows(), 2 * (patch.points.rows() - 1));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Elongation of each bond per ε_xx, ε_yy and 2 ε_xy of an affine strain: n·ε·d.
Eigen::MatrixX3d elongation_by_strain(const PeriodicPatch& patch) {
  const auto dx = patch.bond_vectors.col(0);
  const auto dy = patch.bond_vectors.col(1);
  const Eigen::ArrayXd length = (dx.square() + dy.square()).sqrt();
  Eigen::MatrixX3d elongation(patch.bond_vectors.rows(), 3);
  elongation << dx.square() / length, dy.square() / length, dx * dy / length;
  return elongation;
}

/// Bulk and shear modulus.
struct Moduli {
  double bulk;
  double shear;
};

Moduli average_moduli(const Eigen::Matrix3d& c) {
  return {(c(0, 0) + c(1, 1) + 2.0 * c(0, 1)) / 4.0,
          (c(0, 0) + c(1, 1) - 2.0 * c(0, 1) + 4.0 * c(2, 2)) / 8.0};
}

double norm_of_tensor(const Eigen::Matrix3d& stiffness) {
  const Eigen::Vector3d mandel(1.0, 1.0, std::sqrt(2.0));
  return (mandel.asDiagonal() * stiffness * mandel.asDiagonal()).norm();
}

Eigen::RowVector2d middle(const PointArray& points) {
  return (points.colwise().minCoeff() + points.colwise().maxCoeff()) / 2.0;
}

/// Fraction of the segment between two points that lies in the region about the origin
/// (Y.-D. Liang and B. A. Barsky, ACM Trans. Graphics 3 (1984) 1).
double fraction_inside(const Eigen::RowVector2d& from, const Eigen::RowVector2d& to,
                       const MiddleRegion& region) {
  const Eigen::RowVector2d half(region.half_width, region.half_height);
  double enter = 0.0;
  double leave = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double along = to(axis) - from(axis);
    if (along == 0.0) {
      if (std::abs(from(axis)) > half(axis)) return 0.0;
      continue;
    }
    const double one = (-half(axis) - from(axis)) / along;
    const double other = (half(axis) - from(axis)) / along;
    enter = std::max(enter, std::min(one, other));
    leave = std::min(leave, std::max(one, other));
  }
  return std::max(leave - enter, 0.0);
}

/// The rotation of the polar decomposition.
Eigen::Matrix2d rotation_of(const Eigen::Matrix2d& deformation) {
  const double angle = std::atan2(deformation(1, 0) - deformation(0, 1), deformation.trace());
  Eigen::Matrix2d rotation;
  rotation << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return rotation;
}

}  // namespace

Eigen::Matrix3d periodic_stiffness(const PeriodicPatch& patch, double k_a) {
  const SparseMatrix by_displacement = elongation_by_displacement(patch);
  const Eigen::MatrixX3d by_strain = elongation_by_strain(patch);
  const SparseMatrix transposed = by_displacement.transpose();
  const Eigen::SimplicialLDLT<SparseMatrix> factorised(transposed * by_displacement);
  if (factorised.info() != Eigen::Success) {
    throw std::runtime_error("the stiffness of the periodic patch is singular");
  }
  const Eigen::MatrixXd displacement = -factorised.solve(transposed * by_strain);
  const Eigen::MatrixX3d elongation = by_strain + by_displacement * displacement;
  return k_a / (patch.width * patch.height) * by_strain.transpose() * elongation;
}

ElasticConstants isotropic_average(const Eigen::Matrix3d& stiffness) {
  const auto [bulk, shear] = average_moduli(stiffness);
  return {4.0 * bulk * shear / (bulk + shear), (bulk - shear) / (bulk + shear)};
}

double anisotropy(const Eigen::Matrix3d& stiffness) {
  const auto [bulk, shear] = average_moduli(stiffness);
  Eigen::Matrix3d isotropic;
  isotropic << bulk + shear, bulk - shear, 0.0,  //
      bulk - shear, bulk + shear, 0.0,           //
      0.0, 0.0, shear;
  return norm_of_tensor(stiffness - isotropic) / norm_of_tensor(isotropic);
}

Eigen::Matrix2d mean_stress(const Lattice& lattice, const PointArray& position, const BondLaw& law,
                            const MiddleRegion& region) {
  const Eigen::RowVector2d centre = middle(lattice.points);
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
    const auto [first, second] = lattice.bonds[k];
    const Eigen::RowVector2d from = lattice.points.row(first).matrix() - centre;
    const Eigen::RowVector2d to = lattice.points.row(second).matrix() - centre;
    const Eigen::RowVector2d now = position.row(second) - position.row(first);
    const double x = now.norm() - lattice.natural_lengths[k];
    const double tension = law.k_a * x + law.k_b * x * x * x;
    sum += fraction_inside(from, to, region) * tension * now.normalized().transpose() * (to - from);
  }
  return sum / (4.0 * region.half_width * region.half_height);
}

Eigen::Matrix2d mean_deformation(const Lattice& lattice, const PointArray& position,
                                 const MiddleRegion& region) {
  const PointArray from_middle = lattice.points.rowwise() - middle(lattice.points).array();
  std::vector<Eigen::Index> inside;
  for (Eigen::Index i = 0; i < from_middle.rows(); ++i) {
    if (std::abs(from_middle(i, 0)) <= region.half_width &&
        std::abs(from_middle(i, 1)) <= region.half_height) {
      inside.push_back(i);
    }
  }
  if (inside.size() < 3) {
    return Eigen::Matrix2d::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  Eigen::MatrixX2d before = from_middle(inside, Eigen::all);
  Eigen::MatrixX2d now = position(inside, Eigen::all);
  before.rowwise() -= before.colwise().mean().eval();
  now.rowwise() -= now.colwise().mean().eval();
  const Eigen::Matrix2d spread = before.transpose() * before;
  return now.transpose() * before * spread.inverse();
}

ElasticConstants stretched_constants(const Lattice& lattice, const PointArray& position,
                                     const BondLaw& law, const MiddleRegion& region) {
  const Eigen::Matrix2d deformation = mean_deformation(lattice, position, region);
  const Eigen::Matrix2d back = rotation_of(deformation).transpose();
  const Eigen::Vector2d strain = (back * deformation).diagonal().array() - 1.0;
  const Eigen::Vector2d stress = (back * mean_stress(lattice, position, law, region)).diagonal();
  const double nu = (stress.x() * strain.y() - stress.y() * strain.x()) /
                    (stress.y() * strain.y() - stress.x() * strain.x());
  return {(stress.x() - nu * stress.y()) / strain.x(), nu};
}

}  // namespace impact
