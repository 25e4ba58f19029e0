#include "mechanics/velocity_solver.hpp"

#include <stdexcept>

namespace impact {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// 1 and the entries, those of one place added up.
SparseMatrix added_to_one(std::int32_t size, MatrixEntries& entries) {
  for (std::int32_t i = 0; i < size; ++i) entries.emplace_back(i, i, 1.0);
  SparseMatrix sum(size, size);
  sum.setFromTriplets(entries.begin(), entries.end());
  return sum;
}

/// Adds `factor` times these, with so many rows and columns before them.
void add(const MatrixEntries& more, double factor, std::int32_t before, MatrixEntries& entries) {
  for (const Eigen::Triplet<double>& entry : more) {
    entries.emplace_back(before + entry.row(), before + entry.col(), factor * entry.value());
  }
}

std::int32_t points_of(const ForceField& field) {
  return static_cast<std::int32_t>(field.bonds.points());
}

}  // namespace

SparseMatrix damping_matrix(const ForceField& field, int axis, double scale) {
  MatrixEntries entries;
  add(field.damping(axis), scale / field.point_mass, 0, entries);
  return added_to_one(points_of(field), entries);
}

SparseMatrix damping_and_bonds_matrix(const ForceField& field, double scale) {
  if (!field.unstrained) throw std::invalid_argument("the field has no unstrained positions");
  if (field.supports) throw std::invalid_argument("supports do not go with implicit bonds");
  const std::int32_t points = points_of(field);
  MatrixEntries entries;
  add(field.bonds.stiffness(*field.unstrained), scale * scale / field.point_mass, 0, entries);
  for (int axis = 0; axis < 2; ++axis) {
    add(field.damping(axis), scale / field.point_mass, axis * points, entries);
  }
  return added_to_one(2 * points, entries);
}

void VelocitySolver::factorise(const ForceField& field, double scale) {
  factors_.clear();
  if (implicit_ == Implicit::kDampingAndBonds) {
    factors_.emplace_back(damping_and_bonds_matrix(field, scale), kernels(), Sides::kOne);
    return;
  }
  factors_.emplace_back(damping_matrix(field, 0, scale));
  if (field.viscous_boundary || field.supports) {
    factors_.emplace_back(damping_matrix(field, 1, scale));
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
