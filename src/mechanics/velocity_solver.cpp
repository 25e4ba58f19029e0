#include "mechanics/velocity_solver.hpp"

namespace impact {

Eigen::SparseMatrix<double> damping_matrix(const ForceField& field, int axis, double scale) {
  MatrixEntries entries;
  for (const Eigen::Triplet<double>& entry : field.damping(axis)) {
    entries.emplace_back(entry.row(), entry.col(), scale / field.point_mass * entry.value());
  }
  const auto points = static_cast<std::int32_t>(field.bonds.points());
  for (std::int32_t i = 0; i < points; ++i) entries.emplace_back(i, i, 1.0);
  Eigen::SparseMatrix<double> matrix(points, points);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

void VelocitySolver::factorise(const ForceField& field, double scale) {
  factors_.clear();
  factors_.emplace_back(damping_matrix(field, 0, scale), field.bonds.elimination_order());
  if (field.viscous_boundary || field.supports) {
    factors_.emplace_back(damping_matrix(field, 1, scale), field.bonds.elimination_order());
    y_solution_.resize(field.bonds.points(), 2);
  }
}

void VelocitySolver::prepare(const ForceField& field, double scale) {
  if (scale == scale_) return;
  scale_ = scale;
  factorise(field, scale);
  hold_direction_.resize(0, 2);
  if (!field.hold) return;
  PointArray response = field.hold->direction();
  solve(response);
  hold_direction_ = field.hold->direction();
  hold_response_ = response / (hold_direction_ * response).sum();
}

void VelocitySolver::solve(PointArray& velocity) {
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
