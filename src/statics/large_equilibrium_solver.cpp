#include "statics/large_equilibrium_solver.hpp"

namespace impact {
namespace {

/// About where the next iteration costs more than new factors at N = 10⁵.
constexpr int kMostOfGradients = 8;
/// Of the error of u, in the norm of energy. Newton's method then gains three digits a step at
/// least.
constexpr double kReduction = 1e-3;

Eigen::Map<const Eigen::VectorXd> held_direction(const EquilibriumSearch& search) {
  const PointArray& direction = search.field().hold->direction();
  return {direction.data(), direction.size()};
}

}  // namespace

void LargeEquilibriumSolver::advance(const Searches& searches) {
  if (searches.front() == nullptr || searches.front()->finished()) return;
  EquilibriumSearch& search = *searches.front();
  if (search.needs_stiffness() || stiffness_.empty()) {
    stiffness_.assemble(search.field(), search.state().position);
    if (search.steps() == 0) factor_.reset();
  }
  step(search);
  if (search.needs_correction()) step(search);
}

void LargeEquilibriumSolver::step(EquilibriumSearch& search) {
  std::optional<Vector> solution;
  if (may_iterate(search)) solution = by_conjugate_gradients(search);
  if (!solution) {
    factorise(search);
    solution = factor_->solve(search.force());
  }
  search.take(*solution, response_, stiffness_.largest_diagonal());
}

bool LargeEquilibriumSolver::may_iterate(const EquilibriumSearch& search) const {
  return factor_ && !is_shifted_ && search.shift() == 0.0 &&
         (search.field().hold || search.field().supports);
}

void LargeEquilibriumSolver::factorise(const EquilibriumSearch& search) {
  if (!factor_) factor_.emplace(stiffness_.upper(), search.state().position);
  is_shifted_ = search.shift() > 0.0;
  factor_->factorise(stiffness_.upper(), search.shift() * stiffness_.largest_diagonal());
  if (search.field().hold) response_ = factor_->solve(held_direction(search));
}

LargeEquilibriumSolver::Vector LargeEquilibriumSolver::preconditioned(
    const EquilibriumSearch& search, const Vector& residual) const {
  Vector step = factor_->solve(residual);
  if (search.field().hold) {
    const auto direction = held_direction(search);
    step -= response_ * (direction.dot(step) / direction.dot(response_));
  }
  return step;
}

/// None: they did not converge.
std::optional<LargeEquilibriumSolver::Vector> LargeEquilibriumSolver::by_conjugate_gradients(
    const EquilibriumSearch& search) const {
  const auto stiffness = stiffness_.upper().selfadjointView<Eigen::Upper>();
  Vector solution = Vector::Zero(search.force().size());
  Vector residual = search.force();
  Vector step = preconditioned(search, residual);
  double size = residual.dot(step);
  const double wanted = kReduction * kReduction * size;
  for (int k = 0; k < kMostOfGradients; ++k) {
    const Vector force = stiffness * step;
    const double curvature = step.dot(force);
    if (!(size > 0.0 && curvature > 0.0)) return std::nullopt;
    solution += size / curvature * step;
    residual -= size / curvature * force;
    const Vector next = preconditioned(search, residual);
    const double left = residual.dot(next);
    if (left <= wanted) return solution;
    step = next + left / size * step;
    size = left;
  }
  return std::nullopt;
}

}  // namespace impact
