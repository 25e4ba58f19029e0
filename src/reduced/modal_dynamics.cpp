#include "reduced/modal_dynamics.hpp"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <utility>

namespace impact {

void ForceCourse::add_to(Eigen::VectorXd& force, double time) const {
  const double place = (time - begin) / interval;
  const double last = std::floor(place);
  const double x = place - last;
  const std::array<double, 4> weights{
      0.5 * x * (x * (2.0 - x) - 1.0), 0.5 * (x * x * (3.0 * x - 5.0) + 2.0),
      0.5 * x * (x * (4.0 - 3.0 * x) + 1.0), 0.5 * x * x * (x - 1.0)};
  for (int k = 0; k < 4; ++k) {
    const double column = last - 1.0 + k;
    if (column < 0.0 || column >= static_cast<double>(forces.cols())) continue;
    force += weights[static_cast<std::size_t>(k)] * forces.col(static_cast<Eigen::Index>(column));
  }
}

ModalDynamics::ModalDynamics(ModalSystem system, ModalState start, double step)
    : system_(std::move(system)),
      state_(std::move(start)),
      root_inertia_(std::sqrt(system_.modes->inertia)),
      stiffness_(system_.law.k_a * system_.modes->stiffness) {
  const BulkModes& modes = *system_.modes;
  const Eigen::Index n = modes.arm.rows();
  const auto contacts = static_cast<Eigen::Index>(modes.points.size());
  arm_ = modes.arm(modes.points, Eigen::all);
  Eigen::MatrixXd displacements(2 * contacts, modes.shapes.cols());
  displacements << modes.shapes.topRows(n)(modes.points, Eigen::all),
      modes.shapes.bottomRows(n)(modes.points, Eigen::all);
  displacements.col(0).setZero();
  heights_ = displacements.bottomRows(contacts);
  heights_.col(0) = arm_.col(0).matrix() / root_inertia_;
  displacements_ = PaddedMatrix(displacements);
  transposed_ = PaddedMatrix(displacements.transpose());
  pushes_.resize(2 * contacts);
  middle_ = state_.rates;
  set_step(step);
  update_forces();
}

void ModalDynamics::set_step(double step) {
  step_ = step;
  inertia_ = 1.0 + kAddedInertia * step * step * stiffness_.array();
  Eigen::MatrixXd matrix = 0.5 * step * system_.law.eta * system_.modes->damping;
  matrix.diagonal() += (inertia_ + 0.25 * step * step * stiffness_.array()).matrix();
  inverse_ =
      PaddedMatrix(matrix.llt().solve(Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols())));
  const Eigen::MatrixXd of_modes =
      heights_ * inertia_.inverse().matrix().asDiagonal() * heights_.transpose();
  const double of_the_centre = 1.0;
  response_ = PaddedMatrix((of_modes.array() + of_the_centre).abs().matrix());
}

double ModalDynamics::contact_rate() const {
  response_.multiply(contact_, rates_);
  return system_.wall.a() * rates_.maxCoeff();
}

double ModalDynamics::kinetic_energy() const {
  return 0.5 *
         (state_.velocity * state_.velocity + (inertia_ * state_.rates.array().square()).sum());
}

/// h D q̇½ = 2 (μ q̇ₙ + h Fₙ/2 − (μ + h² Λ/4) q̇½).
double ModalDynamics::step() {
  kicked_ = (inertia_ * state_.rates.array()).matrix() + 0.5 * step_ * force_;
  inverse_.multiply(kicked_, product_);
  middle_ = product_.head(kicked_.size());
  damped_ = 2.0 * (kicked_.array() -
                   (inertia_ + 0.25 * step_ * step_ * stiffness_.array()) * middle_.array());
  state_.amplitudes += step_ * middle_;
  state_.velocity += 0.5 * step_ * force();
  state_.height += step_ * state_.velocity;
  time_ += step_;
  update_forces();
  state_.velocity += 0.5 * step_ * force();
  state_.rates = (kicked_ - damped_ + 0.5 * step_ * force_).array() / inertia_;
  return damped_.dot(middle_);
}

void ModalDynamics::update_forces() {
  const double cos = std::cos(angle());
  const double sin = std::sin(angle());
  const Eigen::Index contacts = arm_.rows();
  displacements_.multiply(state_.amplitudes, displaced_);
  x_ = arm_.col(0) + displaced_.head(contacts).array();
  y_ = arm_.col(1) + displaced_.segment(contacts, contacts).array();
  const Repulsion& wall = system_.wall;
  contact_ = wall.force_at(0.0) * (-wall.a() * (state_.height + sin * x_ + cos * y_)).exp();
  pushes_ << sin * contact_, cos * contact_;
  transposed_.multiply(pushes_, product_);
  force_ = product_.head(state_.amplitudes.size()) - stiffness_.cwiseProduct(state_.amplitudes);
  force_(0) = contact_.dot((cos * x_ - sin * y_).matrix()) / root_inertia_;
  if (system_.correction) system_.correction->add_to(force_, time_);
}

}  // namespace impact
