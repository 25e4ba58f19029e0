#include "mechanics/damping_solver.hpp"

#include <Eigen/SparseCore>

namespace impact {

DampingSolver::DampingSolver(const ForceField& field, double scale) {
  const auto matrix = [&](int axis) {
    std::vector<Eigen::Triplet<double>> entries;
    for (const Eigen::Triplet<double>& entry : field.damping(axis)) {
      entries.emplace_back(entry.row(), entry.col(), scale / field.point_mass * entry.value());
    }
    const auto points = static_cast<std::int32_t>(field.bonds.points());
    for (std::int32_t i = 0; i < points; ++i) entries.emplace_back(i, i, 1.0);
    Eigen::SparseMatrix<double> sum(points, points);
    sum.setFromTriplets(entries.begin(), entries.end());
    return sum;
  };
  factors_.emplace_back(matrix(0));
  if (field.viscous_boundary || field.supports) factors_.emplace_back(matrix(1));
  if (factors_.size() > 1) y_solution_.resize(field.bonds.points(), 2);
  if (!field.hold) return;
  PointArray response = field.hold->direction();
  solve(response);
  hold_direction_ = field.hold->direction();
  hold_response_ = response / (hold_direction_ * response).sum();
}

void DampingSolver::solve(PointArray& velocity) {
  if (factors_.size() > 1) {
    y_solution_ = velocity;
    factors_[1].solve(y_solution_);
  }
  factors_[0].solve(velocity);
  if (factors_.size() > 1) velocity.col(1) = y_solution_.col(1);
  if (hold_direction_.size() == 0) return;
  const double broken = (hold_direction_ * velocity).sum();
  velocity -= broken * hold_response_;
}

}  // namespace impact
