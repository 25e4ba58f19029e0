#include "mechanics/mid_step_solver.hpp"

#include <stdexcept>

#include "mechanics/kick.hpp"
#include "mechanics/velocity_solver.hpp"

namespace impact {
namespace {

BondForces with_unit_viscosity(const ForceField& field) {
  if (field.bonds.has_two_laws() || field.supports) {
    throw std::invalid_argument("bonds of two laws and supports do not go with implicit bonds");
  }
  BondLaw law = field.bonds.law();
  law.eta = 1.0;
  return field.bonds.with(law);
}

}  // namespace

MidStepSolver::MidStepSolver(const ForceField& field)
    : differences_of_(with_unit_viscosity(field)),
      law_(field.bonds.law()),
      point_mass_(field.point_mass),
      is_held_(field.hold.has_value()) {
  if (!field.unstrained) throw std::invalid_argument("the field has no unstrained positions");
  arm_ = field.unstrained->rowwise() - field.unstrained->colwise().mean();
  rotation_.emplace(*field.unstrained);
}

void MidStepSolver::prepare(double h) {
  if (h == step_) return;
  step_ = h;
  const double damping = 0.5 * h * law_.eta / point_mass_;
  coupling_ = damping + 0.25 * h * h * law_.k_a / point_mass_;
  factor_.emplace(damping_matrix(ForceField{differences_of_}, 0, coupling_),
                  differences_of_.elimination_order());

  const PointArray& r = rotation();
  const double r_squared = dot(r, r);
  held_response_ = r;
  factor_->solve(held_response_);
  held_differences_ = (r - held_response_) / coupling_;
  held_share_ = 1.0 / dot(r, held_response_);

  const double part = damping / coupling_;
  const PointArray within = r - r_squared * held_share_ * held_response_;
  const PointArray of_rotation = laplacian_of(r);
  turning_response_ = r - part * within;
  turning_differences_ = of_rotation - part * laplacian_of(within);
  const double resisted = damping * dot(turning_response_, of_rotation);
  turning_share_ = is_held_ ? 0.0 : 1.0 / (r_squared + resisted);
}

PointArray MidStepSolver::laplacian_of(const PointArray& x) {
  PointArray product(x.rows(), 2);
  differences_of_.evaluate_damping(x, product);
  return -product;
}

/// Less the mean, with s = B⁻¹ b, α = p·b/p·A r and μ = r·s/r·z, u = s + α p − μ z; and
/// L s = (b − s)/c.
void MidStepSolver::solve(PointArray& velocity, PointArray& differences) {
  const Eigen::Array2d mean = velocity.colwise().mean();
  for (const int axis : {0, 1}) velocity.col(axis) -= mean(axis);
  const double turning = turning_share_ * dot(turning_response_, velocity);
  differences = velocity;
  factor_->solve(velocity);
  const double held = held_share_ * dot(rotation(), velocity);

  differences = 1.0 / coupling_ * (differences - velocity) + turning * turning_differences_ -
                held * held_differences_;
  for (const int axis : {0, 1}) {
    velocity.col(axis) +=
        turning * turning_response_.col(axis) - held * held_response_.col(axis) + mean(axis);
  }
  if (is_held_) rotation_->take_out_rotation(differences);
}

}  // namespace impact
