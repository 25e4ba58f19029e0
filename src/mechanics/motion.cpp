#include "mechanics/motion.hpp"

#include <cmath>
#include <utility>

namespace impact {
Motion::Motion(ForceField field, State initial, const Spectrum& spectrum, double step)
    : System(std::move(field), std::move(initial), step), spectrum_(spectrum) {}

void Motion::limit_step(const Contact& wall, double approach, const StepBound& bound) {
  const double margin = kWallMargin * wall.moving_ends();
  const auto limit = [&] {
    const double force = wall.largest_force() * std::exp(wall.a() * approach * step_size_);
    const double omega_squared =
        spectrum_.omega_squared + margin * wall.stiffness(force) / field_.point_mass;
    return bound.step_limit(omega_squared, spectrum_.gamma);
  };
  while (step_size_ > limit()) {
    step_size_ /= 2.0;
    ticks_ *= 2;
    ++halvings_;
  }
}

void Motion::count_step(const Losses& lost) {
  losses_.dissipated += lost.dissipated;
  losses_.absorbed += lost.absorbed;
  ++ticks_;
  ++state_.step;
  state_.time = static_cast<double>(ticks_) * step_size_;
}

bool Motion::reset_is_due() const {
  if (!field_.velocity_reset) return false;
  const double interval = field_.velocity_reset->interval();
  return ticks_ % static_cast<std::uint64_t>(std::llround(interval / step_size_)) == 0;
}

}  // namespace impact
