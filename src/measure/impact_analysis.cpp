#include "measure/impact_analysis.hpp"

#include <cmath>

namespace impact {
namespace {

/// Of the disk's speed, what a throw straight at the wall may slide at.
constexpr double kRounding = 1e-12;

/// Twice the energy of the spin, M c², with this moment of inertia.
double rotation(const BodyMotion& motion, double moment_of_inertia) {
  return motion.angular_momentum * motion.angular_momentum / moment_of_inertia;
}

/// Twice the energy of translation and rotation, M c², with this moment of inertia.
double rigid_energy(const BodyMotion& motion, double moment_of_inertia) {
  return motion.velocity.square().sum() + rotation(motion, moment_of_inertia);
}

}  // namespace

void ImpactAnalysis::add(const State& state) {
  latest_ = body_motion(state.position, state.velocity);
  if (!before_) before_ = latest_;
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
  if (before_) {
    result.velocity_before = before_->velocity.y();
    result.tangential_velocity_before = before_->velocity.x();
    result.spin_before = before_->spin();
    result.moment_of_inertia = before_->moment_of_inertia;
  }
  result.contact_begin = contact_.begin();
  if (!before_ || !separated) return result;
  result.velocity_after = latest_.velocity.y();
  result.restitution = -result.velocity_after / result.velocity_before;
  result.tangential_velocity_after = latest_.velocity.x();
  result.spin_after = latest_.angular_momentum / before_->moment_of_inertia;
  const double inertia = result.moment_of_inertia;
  const double energy = rigid_energy(*before_, inertia);
  result.energy_restitution = std::sqrt(rigid_energy(latest_, inertia) / energy);
  result.normal_energy = latest_.velocity.y() * latest_.velocity.y() / energy;
  result.tangential_energy = latest_.velocity.x() * latest_.velocity.x() / energy;
  result.rotation_energy = rotation(latest_, inertia) / energy;
  const double sliding = before_->velocity.x() + result.spin_before;
  if (std::abs(sliding) > kRounding * std::sqrt(energy)) {
    result.tangential_restitution = -(latest_.velocity.x() + result.spin_after) / sliding;
  }
  result.impulse_ratio = (latest_.velocity.x() - before_->velocity.x()) /
                         (latest_.velocity.y() - before_->velocity.y());
  result.contact_end = contact_.end();
  result.contact_duration = contact_.duration();
  result.peak_force = contact_.peak_force();
  result.impulse = impulse_;
  return result;
}

}  // namespace impact
