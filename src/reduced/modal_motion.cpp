#include "reduced/modal_motion.hpp"

#include <cmath>
#include <utility>

#include "mechanics/body_motion.hpp"

namespace impact {
namespace {

constexpr double kMostStiffness = 4.0;  // times m/h²

std::shared_ptr<const ForceCourse> delayed(const ModalCorrection& correction, double delay) {
  if (!correction.forces || delay == 0.0) return correction.forces;
  auto later = std::make_shared<ForceCourse>(*correction.forces);
  later->begin += delay;
  return later;
}

}  // namespace

ModalMotion::ModalMotion(ForceField field, State initial,
                         const std::shared_ptr<const BulkModes>& modes,
                         const ModalCorrection& correction, double delay, double step)
    : System(std::move(field), std::move(initial), step),
      x_(state_.position.col(0).mean()),
      sideways_(state_.velocity.col(0).mean()),
      left_out_(correction.left_out),
      dynamics_({modes, field_.bonds.law(), field_.wall->repulsion(), delayed(correction, delay)},
                modal_state(*modes, state_), step) {
  take_force();
}

void ModalMotion::step() {
  limit_step();
  losses_.dissipated += dynamics_.step();
  ++state_.step;
  state_.time = dynamics_.time();
  take_force();
  is_current_ = false;
}

void ModalMotion::take_force() {
  ++field_.evaluations;
  field_.wall->take_in({0.0, dynamics_.force()}, dynamics_.largest_force());
}

void ModalMotion::limit_step() {
  const double way = field_.wall->a() * std::abs(dynamics_.state().velocity);
  const auto rate = [&](double step) { return dynamics_.contact_rate() * std::exp(way * step); };
  stiffest_contact_ = std::max(stiffest_contact_, rate(std::ldexp(step_size_, halvings_)));
  while (step_size_ * step_size_ * rate(step_size_) > kMostStiffness) {
    step_size_ /= 2.0;
    ++halvings_;
    dynamics_.set_step(step_size_);
  }
}

/// To first order in the displacements.
double ModalMotion::kinetic_energy() const {
  return 0.5 * sideways_ * sideways_ + dynamics_.kinetic_energy();
}

const State& ModalMotion::state() const {
  if (!is_current_) recover();
  is_current_ = true;
  return state_;
}

/// r = R + T (s + u), v = V + ω × (r − R) + T du/dt, T the rotation by the angle.
void ModalMotion::recover() const {
  const BulkModes& modes = *dynamics_.system().modes;
  const ModalState& now = dynamics_.state();
  const Eigen::Index n = modes.arm.rows();
  const Eigen::ArrayXd u = elastic_displacements(modes, now.amplitudes);
  const Eigen::ArrayXd growth = elastic_displacements(modes, now.rates);
  const double cos = std::cos(dynamics_.angle());
  const double sin = std::sin(dynamics_.angle());
  const double spin = dynamics_.spin();
  const Eigen::ArrayXd along = modes.arm.col(0) + u.head(n);
  const Eigen::ArrayXd up = modes.arm.col(1) + u.tail(n);
  const Eigen::ArrayXd x = cos * along - sin * up;
  const Eigen::ArrayXd y = sin * along + cos * up;
  state_.position.col(0) = x_ + sideways_ * state_.time + x;
  state_.position.col(1) = now.height + y;
  state_.velocity.col(0) = sideways_ - spin * y + cos * growth.head(n) - sin * growth.tail(n);
  state_.velocity.col(1) = now.velocity + spin * x + sin * growth.head(n) + cos * growth.tail(n);
}

}  // namespace impact
