#include "run/balance.hpp"

#include <cmath>
#include <utility>

namespace impact {

Lattice balanced(Lattice lattice) {
  const Eigen::Array2d centre = lattice.points.colwise().mean();
  Eigen::Index farthest = 0;
  (lattice.points.rowwise() - centre.transpose()).square().rowwise().sum().maxCoeff(&farthest);
  const Eigen::Array2d arm = lattice.points.row(farthest).transpose() - centre;
  const double length = std::hypot(arm.x(), arm.y());
  const double cosine = -arm.y() / length;  // of the angle that brings the arm to −y
  const double sine = -arm.x() / length;
  PointArray turned(lattice.points.rows(), 2);
  turned.col(0) = cosine * lattice.points.col(0) - sine * lattice.points.col(1);
  turned.col(1) = sine * lattice.points.col(0) + cosine * lattice.points.col(1);
  return make_lattice(std::move(turned), std::move(lattice.bonds));
}

}  // namespace impact
