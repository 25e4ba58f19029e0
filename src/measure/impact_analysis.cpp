#include "measure/impact_analysis.hpp"

#include <cmath>

namespace impact {
namespace {

/// Of the disk's speed, what a throw straight at the wall may slide at.
constexpr double kRounding = 1e-12;

/// Twice the energy of the spin over the mass, c², with the inertia that the body had.
double rotation(const BodyMotion& now, const BodyMotion& before) {
  return now.angular_momentum * now.angular_momentum / before.moment_of_inertia;
}

double squared(double number) { return number * number; }

}  // namespace

void ImpactAnalysis::add(const State& state) {
  latest_.first = body_motion(state.position, state.velocity);
  if (!before_) touching_height_ = latest_.first.centre.y() - state.position.col(1).minCoeff();
  if (gravity_ != 0.0) latest_.first = where_it_touches(latest_.first);
  if (!before_) before_ = latest_;
}

/// With the velocity that free flight has there; NaN if it does not come so high.
BodyMotion ImpactAnalysis::where_it_touches(BodyMotion motion) const {
  double& v = motion.velocity.y();
  const double fall = 2.0 * gravity_ * (motion.centre.y() - touching_height_);
  v = std::copysign(std::sqrt(v * v + fall), v);
  return motion;
}

void ImpactAnalysis::add(const State& state, const State& second) {
  latest_.second = body_motion(second.position, second.velocity);
  latest_.second_mass =
      static_cast<double>(second.position.rows()) / static_cast<double>(state.position.rows());
  if (!before_) second_radius_ = second.position.col(1).maxCoeff() - latest_.second->centre.y();
  add(state);
}

/// Twice the energies of the rigid motion of what flies, M c².
ImpactAnalysis::Shares ImpactAnalysis::shares(const Motions& motions) const {
  const auto& [first, second, mass] = motions;
  Shares shares{squared(first.velocity.y()), squared(first.velocity.x()),
                rotation(first, before_->first)};
  if (second) {
    shares.normal += mass * squared(second->velocity.y());
    shares.tangential += mass * squared(second->velocity.x());
    shares.rotation += mass * rotation(*second, *before_->second);
  }
  return shares;
}

/// Of the first body's surface where it touches, along what it touches.
double ImpactAnalysis::sliding(const Motions& motions) const {
  const auto& [first, second, mass] = motions;
  const double of_first =
      first.velocity.x() + first.angular_momentum / before_->first.moment_of_inertia;
  if (!second) return of_first;
  const double spin = second->angular_momentum / before_->second->moment_of_inertia;
  return of_first - (second->velocity.x() - second_radius_ * spin);
}

void ImpactAnalysis::add(const ContactReport& report) {
  for (const ForceSample& sample : report.samples) {
    contact_.add(sample);
    if (last_sample_) {
      impulse_ += 0.5 * (last_sample_->force + sample.force) * (sample.time - last_sample_->time);
    }
    last_sample_ = sample;
  }
}

Restitution ImpactAnalysis::restitution(bool separated) const {
  Restitution result;
  result.contact_begin = contact_.begin();
  if (!before_) return result;
  say_before(result);
  if (!separated) return result;
  say_after(result);
  result.contact_end = contact_.end();
  result.contact_duration = contact_.duration();
  result.peak_force = contact_.peak_force();
  result.impulse = impulse_;
  return result;
}

void ImpactAnalysis::say_before(Restitution& result) const {
  const BodyMotion& before = before_->first;
  result.velocity_before = before.velocity.y();
  result.tangential_velocity_before = before.velocity.x();
  result.spin_before = before.spin();
  result.moment_of_inertia = before.moment_of_inertia;
  result.energy_before = 0.5 * shares(*before_).sum();
}

void ImpactAnalysis::say_after(Restitution& result) const {
  const BodyMotion& before = before_->first;
  const BodyMotion& after = latest_.first;
  const double energy = shares(*before_).sum();
  result.velocity_after = after.velocity.y();
  result.restitution = -result.velocity_after / result.velocity_before;
  result.tangential_velocity_after = after.velocity.x();
  result.spin_after = after.angular_momentum / before.moment_of_inertia;
  const Shares left = shares(latest_);
  result.energy_restitution = std::sqrt(left.sum() / energy);
  result.normal_energy = left.normal / energy;
  result.tangential_energy = left.tangential / energy;
  result.rotation_energy = left.rotation / energy;
  const double slid = sliding(*before_);
  if (std::abs(slid) > kRounding * std::sqrt(energy)) {
    result.tangential_restitution = -sliding(latest_) / slid;
  }
  result.impulse_ratio =
      (after.velocity.x() - before.velocity.x()) / (after.velocity.y() - before.velocity.y());
}

}  // namespace impact
