#include "reduced/reduced_motion.hpp"

#include <cmath>
#include <utility>

#include "mechanics/body_motion.hpp"
#include "reduced/left_out.hpp"

namespace impact {

ReducedMotion::ReducedMotion(ForceField field, State initial,
                             std::shared_ptr<Compliance> compliance, double negligible_energy,
                             double step)
    : System(std::move(field), std::move(initial), step),
      contact_(about_the_centre(state_.position), std::move(compliance), field_.bonds.law().k_a,
               *field_.wall, field_.wall->a() * negligible_energy) {
  const BodyMotion motion = body_motion(state_.position, state_.velocity);
  inertia_ = motion.moment_of_inertia;
  x_ = motion.centre.x();
  sideways_ = motion.velocity.x();
  pose_ = {motion.centre.y(), 0.0};
  rate_ = {motion.velocity.y(), motion.spin()};
  speed_before_ = std::abs(rate_.velocity);
  take_pose();
}

void ReducedMotion::step() {
  kick(0.5 * step_size_);
  pose_.height += step_size_ * rate_.velocity;
  pose_.angle += step_size_ * rate_.spin;
  take_pose();
  kick(0.5 * step_size_);
  ++state_.step;
  state_.time = static_cast<double>(state_.step) * step_size_;
  is_current_ = false;
}

void ReducedMotion::kick(double time) {
  rate_.velocity += time * contact_.force();
  rate_.spin += time * contact_.torque() / inertia_;
}

void ReducedMotion::take_pose() {
  contact_.take(pose_);
  ++field_.evaluations;
  field_.wall->take_in({0.0, contact_.force()}, contact_.largest_force());
  poses_.push_back(pose_);
  spins_.push_back(rate_.spin);
  forces_.push_back(contact_.force());
}

double ReducedMotion::kinetic_energy() const {
  return 0.5 * (sideways_ * sideways_ + rate_.velocity * rate_.velocity +
                inertia_ * rate_.spin * rate_.spin);
}

const State& ReducedMotion::state() const {
  if (!is_current_) recover();
  is_current_ = true;
  return state_;
}

/// r = R + T (s + u), v = V + ω × (r − R) + T du/dt, T the rotation by the angle of the pose.
void ReducedMotion::recover() const {
  const PointArray elastic = contact_.displacements(rate_);
  const Eigen::Index n = contact_.arm().rows();
  const double cos = std::cos(pose_.angle);
  const double sin = std::sin(pose_.angle);
  const auto u = elastic.col(0);
  const auto growth = elastic.col(1);
  const PointArray& s = contact_.arm();
  const Eigen::ArrayXd x = cos * (s.col(0) + u.head(n)) - sin * (s.col(1) + u.tail(n));
  const Eigen::ArrayXd y = sin * (s.col(0) + u.head(n)) + cos * (s.col(1) + u.tail(n));
  state_.position.col(0) = x_ + sideways_ * state_.time + x;
  state_.position.col(1) = pose_.height + y;
  state_.velocity.col(0) = sideways_ - rate_.spin * y + cos * growth.head(n) - sin * growth.tail(n);
  state_.velocity.col(1) =
      rate_.velocity + rate_.spin * x + sin * growth.head(n) + cos * growth.tail(n);
}

ModelError ReducedMotion::model_error() const {
  return left_out({contact_, field_, poses_, spins_, forces_, step_size_, inertia_, speed_before_,
                   std::abs(rate_.velocity)});
}

}  // namespace impact
