#include "solvers/reduced_system.hpp"

namespace impact {

ReducedSystem::ReducedSystem(const ForceField& field) : point_mass_(field.point_mass) {
  const auto points = static_cast<std::int32_t>(field.bonds.points());
  std::vector<Eigen::Triplet<double>> entries;
  for (const int axis : {0, 1}) {
    for (const Eigen::Triplet<double>& entry : field.damping(axis)) {
      entries.emplace_back(axis * points + entry.row(), axis * points + entry.col(), entry.value());
    }
  }
  const Eigen::Index coordinates = 2 * field.bonds.points();
  damping_.resize(coordinates, coordinates);
  damping_.setFromTriplets(entries.begin(), entries.end());
  work_.resize(coordinates);
  if (field.hold) {
    const PointArray& direction = field.hold->direction();
    hold_direction_ = Eigen::Map<const Eigen::VectorXd>(direction.data(), direction.size());
  }
}

void ReducedSystem::set_stiffness(const ForceField& field, const PointArray& position) {
  std::vector<Eigen::Triplet<double>> entries = field.stiffness(position);
  const auto coordinates = static_cast<std::int32_t>(2 * position.rows());
  for (std::int32_t i = 0; i < coordinates; ++i) entries.emplace_back(i, i, 0.0);
  stiffness_.resize(coordinates, coordinates);
  stiffness_.setFromTriplets(entries.begin(), entries.end());
}

bool ReducedSystem::factorise(double gamma) {
  gamma_ = gamma;
  sum_ = (gamma / point_mass_) * damping_ + (gamma * gamma / point_mass_) * stiffness_;
  sum_.diagonal().array() += 1.0;
  if (!ordered_) factors_.analyzePattern(sum_);
  ordered_ = true;
  factors_.factorize(sum_);
  if (factors_.info() != Eigen::Success) return false;
  pivots_ = factors_.vectorD();
  if (hold_direction_.size() == 0) return true;
  hold_response_ = factors_.solve(hold_direction_);
  hold_response_ /= hold_direction_.dot(hold_response_);
  return true;
}

void ReducedSystem::solve(double* r) {
  const Eigen::Index coordinates = work_.size();
  FirstOrderForm::Vector position(r, coordinates);
  FirstOrderForm::Vector velocity(r + coordinates, coordinates);
  const bool held = hold_direction_.size() != 0;
  const double turn = held ? hold_direction_.dot(velocity) : 0.0;
  work_.noalias() = stiffness_ * position;
  velocity -= (gamma_ / point_mass_) * work_;
  // As factors_.solve(), which takes memory from the heap.
  work_.noalias() = factors_.permutationP() * velocity;
  factors_.matrixL().solveInPlace(work_);
  work_.array() /= pivots_.array();
  factors_.matrixU().solveInPlace(work_);
  velocity.noalias() = factors_.permutationPinv() * work_;
  if (held) velocity -= (hold_direction_.dot(velocity) - turn) * hold_response_;
  position += gamma_ * velocity;
}

}  // namespace impact
