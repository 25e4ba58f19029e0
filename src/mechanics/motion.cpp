#include "mechanics/motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace impact {
Motion::Motion(ForceField field, State initial, const Spectrum& spectrum, double step)
    : System(std::move(field), std::move(initial), step), spectrum_(spectrum) {
  if (const Contact* const wall = field_.contact()) {
    inner_share_ = inner_share(wall->a(), spacing(field_.first_body().points));
  }
}

double Motion::spacing(Eigen::Index points) {
  return std::sqrt(M_PI / static_cast<double>(points));
}

double Motion::inner_share(double a, double spacing) {
  return std::exp(-a * kDepthOfOuterPoints * spacing);
}

void Motion::limit_step(const Contact& wall, double approach, const StepBound& bound) {
  const double margin =
      wall_margin(bound.solves_for_bonds()) * wall.moving_ends() / field_.point_mass;
  const auto rate = [&](double step) {
    return margin * wall.stiffness(wall.largest_force() * std::exp(wall.a() * approach * step));
  };
  stiffest_contact_ = std::max(stiffest_contact_, rate(std::ldexp(step_size_, halvings_)));
  while (step_size_ > bound.step_limit_with(spectrum_, rate(step_size_), inner_share_)) {
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
