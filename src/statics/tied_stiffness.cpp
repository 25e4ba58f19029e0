#include "statics/tied_stiffness.hpp"

#include <cmath>

#include "mechanics/bond_forces.hpp"

namespace impact {
namespace {

/// A point and the one furthest from it; where the first is held and the second cannot turn about
/// it, the lattice is at rest.
struct Ties {
  Eigen::Index held;
  Eigen::Index guided;
  Eigen::Array2d normal;  ///< of the line between them
};

Ties ties_of(const PointArray& points) {
  Ties ties{};
  points.square().rowwise().sum().maxCoeff(&ties.held);
  const PointArray way = points.rowwise() - points.row(ties.held);
  const double length = std::sqrt(way.square().rowwise().sum().maxCoeff(&ties.guided));
  ties.normal = Eigen::Array2d(-way(ties.guided, 1), way(ties.guided, 0)) / length;
  return ties;
}

}  // namespace

Eigen::SparseMatrix<double> tied_stiffness(const Lattice& lattice) {
  const Eigen::Index n = lattice.points.rows();
  auto entries = BondForces(lattice, {1.0, 0.0, 0.0}).stiffness(lattice.points);
  const Ties ties = ties_of(lattice.points);
  for (int i = 0; i < 2; ++i) {
    entries.emplace_back(i * n + ties.held, i * n + ties.held, 1.0);
    for (int j = 0; j < 2; ++j) {
      entries.emplace_back(i * n + ties.guided, j * n + ties.guided,
                           ties.normal(i) * ties.normal(j));
    }
  }
  Eigen::SparseMatrix<double> matrix(2 * n, 2 * n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace impact
