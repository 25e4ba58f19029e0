#include "lattice/rigidity.hpp"

#include <Eigen/SparseCholesky>
#include <array>
#include <utility>
#include <vector>

namespace impact {
namespace {

/// Farthest from the first point, so that holding both holds the rotation well.
Eigen::Index far_point(const Lattice& lattice) {
  Eigen::Index far = 0;
  (lattice.points.rowwise() - lattice.points.row(0)).square().rowwise().sum().maxCoeff(&far);
  return far;
}

/// The place of each component in the matrix; −1: held. Rows as x, y of each point.
std::vector<Eigen::Index> free_components(const Lattice& lattice) {
  const Eigen::Index far = far_point(lattice);
  const Eigen::Array<double, 1, 2> way = (lattice.points.row(far) - lattice.points.row(0)).abs();
  const Eigen::Index across = way(0) > way(1) ? 1 : 0;
  std::vector<Eigen::Index> place(static_cast<std::size_t>(2 * lattice.points.rows()));
  Eigen::Index next = 0;
  for (Eigen::Index k = 0; k < 2 * lattice.points.rows(); ++k) {
    const bool held = k < 2 || k == 2 * far + across;
    place[static_cast<std::size_t>(k)] = held ? -1 : next++;
  }
  return place;
}

}  // namespace

bool is_floppy(const Lattice& lattice) {
  const Eigen::Index points = lattice.points.rows();
  if (static_cast<Eigen::Index>(lattice.bonds.size()) < 2 * points - 3) return true;
  const std::vector<Eigen::Index> place = free_components(lattice);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(16 * lattice.bonds.size());
  for (const Bond& bond : lattice.bonds) {
    const Eigen::Vector2d n =
        (lattice.points.row(bond.second) - lattice.points.row(bond.first)).matrix().normalized();
    const std::array<std::pair<Eigen::Index, double>, 4> parts{
        {{2 * Eigen::Index{bond.first}, -n.x()},
         {2 * Eigen::Index{bond.first} + 1, -n.y()},
         {2 * Eigen::Index{bond.second}, n.x()},
         {2 * Eigen::Index{bond.second} + 1, n.y()}}};
    for (const auto& [row, of_row] : parts) {
      for (const auto& [column, of_column] : parts) {
        const Eigen::Index i = place[static_cast<std::size_t>(row)];
        const Eigen::Index j = place[static_cast<std::size_t>(column)];
        if (i >= 0 && j >= 0) entries.emplace_back(i, j, of_row * of_column);
      }
    }
  }
  const Eigen::Index size = 2 * points - 3;
  Eigen::SparseMatrix<double> stiffness(size, size);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(stiffness);
  if (factors.info() != Eigen::Success) return true;
  constexpr double kLeastPivot = 1e-12;
  const Eigen::VectorXd pivots = factors.vectorD();
  return pivots.minCoeff() < kLeastPivot * pivots.maxCoeff();
}

}  // namespace impact
