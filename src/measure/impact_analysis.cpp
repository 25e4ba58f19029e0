#include "measure/impact_analysis.hpp"

#include <array>
#include <cmath>

#include "mechanics/body.hpp"

namespace impact {
namespace {

/// Of the disk's speed, what a throw straight at the wall may slide at.
constexpr double kRounding = 1e-12;

/// Twice the energy of the spin over the mass, c², with the inertia that the body had.
double rotation(const BodyMotion& now, const BodyMotion& before) {
  return now.angular_momentum * now.angular_momentum / before.moment_of_inertia;
}

/// With the inertia that the body had, c/R.
double spin(const BodyMotion& now, const BodyMotion& before) {
  return now.angular_momentum / before.moment_of_inertia;
}

/// Of a disk that was met.
struct NumbersOfOther {
  double Restitution::*velocity_after;
  double Restitution::*tangential_velocity_after;
  double Restitution::*spin_after;
};
constexpr std::array<NumbersOfOther, kMostBodies - 1> kNumbersOfOthers{
    {{&Restitution::wall_velocity_after, &Restitution::wall_tangential_velocity_after,
      &Restitution::wall_spin_after},
     {&Restitution::wall2_velocity_after, &Restitution::wall2_tangential_velocity_after,
      &Restitution::wall2_spin_after},
     {&Restitution::wall3_velocity_after, &Restitution::wall3_tangential_velocity_after,
      &Restitution::wall3_spin_after}}};

double squared(double number) { return number * number; }

}  // namespace

void ImpactAnalysis::add(const State& state, const std::vector<State>& others) {
  latest_.others.clear();
  for (const State& other : others) {
    latest_.others.push_back(
        {body_motion(other.position, other.velocity),
         static_cast<double>(other.position.rows()) / static_cast<double>(state.position.rows())});
  }
  if (!before_ && !others.empty()) {
    radius_of_touched_ =
        others.front().position.col(1).maxCoeff() - latest_.others.front().motion.centre.y();
  }
  latest_.first = body_motion(state.position, state.velocity);
  if (!before_) touching_height_ = latest_.first.centre.y() - state.position.col(1).minCoeff();
  if (gravity_ != 0.0) latest_.first = where_it_touches(latest_.first);
  if (!before_) before_ = latest_;
}

void ImpactAnalysis::add(const BodyMotion& motion) {
  latest_ = {motion, {}};
  before_ = before_.value_or(latest_);
}

/// With the velocity that free flight has there; NaN if it does not come so high.
BodyMotion ImpactAnalysis::where_it_touches(BodyMotion motion) const {
  double& v = motion.velocity.y();
  const double fall = 2.0 * gravity_ * (motion.centre.y() - touching_height_);
  v = std::copysign(std::sqrt(v * v + fall), v);
  return motion;
}

/// Twice the energies of the rigid motion of what flies, M c².
ImpactAnalysis::Shares ImpactAnalysis::shares(const Motions& motions) const {
  const BodyMotion& first = motions.first;
  Shares shares{squared(first.velocity.y()), squared(first.velocity.x()),
                rotation(first, before_->first)};
  for (std::size_t k = 0; k < motions.others.size(); ++k) {
    const auto& [motion, mass] = motions.others[k];
    shares.normal += mass * squared(motion.velocity.y());
    shares.tangential += mass * squared(motion.velocity.x());
    shares.rotation += mass * rotation(motion, before_->others[k].motion);
  }
  return shares;
}

/// Of the first body's surface where it touches, along what it touches.
double ImpactAnalysis::sliding(const Motions& motions) const {
  const double of_first = motions.first.velocity.x() + spin(motions.first, before_->first);
  if (motions.others.empty()) return of_first;
  const BodyMotion& touched = motions.others.front().motion;
  const double spin_of_touched = spin(touched, before_->others.front().motion);
  return of_first - (touched.velocity.x() - radius_of_touched_ * spin_of_touched);
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
  result.spin_after = spin(after, before);
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
  if (!latest_.others.empty()) say_of_others(result);
}

void ImpactAnalysis::say_of_others(Restitution& result) const {
  for (std::size_t k = 0; k < latest_.others.size(); ++k) {
    const BodyMotion& after = latest_.others[k].motion;
    result.*kNumbersOfOthers[k].velocity_after = after.velocity.y();
    result.*kNumbersOfOthers[k].tangential_velocity_after = after.velocity.x();
    result.*kNumbersOfOthers[k].spin_after = spin(after, before_->others[k].motion);
  }
  if (latest_.others.size() == 1) return;
  const Other& last = latest_.others.back();
  const double at_start = before_->others.back().motion.velocity.y();
  const double approach = before_->first.velocity.y() - at_start;
  result.momentum_passed_on = last.mass * (last.motion.velocity.y() - at_start) / approach;
  result.restitution_of_ends = -(latest_.first.velocity.y() - last.motion.velocity.y()) / approach;
}

}  // namespace impact
