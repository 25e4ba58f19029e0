#include "measure/contact_time.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace impact {
namespace {

bool is_there(const ForceSample& sample) { return !std::isnan(sample.time); }

/// The slope from one point to the other.
double slope(double x0, double y0, double x1, double y1) { return (y1 - y0) / (x1 - x0); }

/// The polynomial through the logarithms of four forces, by divided differences.
class LogarithmicCubic {
 public:
  LogarithmicCubic(const ForceSample& a, const ForceSample& b, const ForceSample& c,
                   const ForceSample& d)
      : a_(a.time), b_(b.time), c_(c.time), value_(std::log(a.force)) {
    const double log_b = std::log(b.force);
    const double log_c = std::log(c.force);
    const double bc = slope(b.time, log_b, c.time, log_c);
    const double cd = slope(c.time, log_c, d.time, std::log(d.force));
    slope_ = slope(a.time, value_, b.time, log_b);
    second_ = slope(a.time, slope_, c.time, bc);
    third_ = slope(a.time, second_, d.time, slope(b.time, bc, d.time, cd));
  }

  double operator()(double time) const {
    return value_ + (time - a_) * (slope_ + (time - b_) * (second_ + (time - c_) * third_));
  }

 private:
  double a_, b_, c_;
  double value_;
  double slope_;
  double second_;
  double third_;
};

}  // namespace

void ContactTime::add(const ForceSample& sample) {
  if (!rise_.empty() && rise_.back().to.time == last_.to.time) rise_.back().after = sample;
  if (fall_.to.time == last_.to.time) fall_.after = sample;
  last_ = {last_.from, last_.to, sample, kNone};
  if (rise_.empty() || sample.force > rise_.back().to.force) {
    rise_.push_back(last_);
    while (rise_.front().to.force <= threshold() && rise_.size() > 1) rise_.pop_front();
  }
  if (last_.from.force > threshold()) fall_ = last_;
}

double ContactTime::peak_force() const {
  if (rise_.empty()) return kNaN;
  const auto& [before, from, to, after] = rise_.back();
  if (!is_there(from) || !is_there(after)) return to.force;
  const double rise = slope(from.time, from.force, to.time, to.force);
  const double fall = slope(to.time, to.force, after.time, after.force);
  const double curvature = (fall - rise) / (after.time - from.time);
  const double rate = rise + curvature * (to.time - from.time);
  return curvature < 0.0 ? to.force - rate * rate / (4.0 * curvature) : to.force;
}

double ContactTime::begin() const {
  return !rise_.empty() && rise_.back().to.force > 0.0 ? crossing(rise_.front()) : kNaN;
}

double ContactTime::end() const { return fall_.to.force <= threshold() ? crossing(fall_) : kNaN; }

double ContactTime::crossing(const Step& step) const {
  const auto& [before, from, to, after] = step;
  if (!is_there(from)) return to.time;
  const double level = kContactFraction * peak_force();
  const double length = to.time - from.time;
  if (from.force <= 0.0 || to.force <= 0.0) {
    return from.time + length * (level - from.force) / (to.force - from.force);
  }
  if (before.force > 0.0 && after.force > 0.0 && (from.force > level) != (to.force > level)) {
    const LogarithmicCubic cubic(before, from, to, after);
    const double log_level = std::log(level);
    const auto above = [&](double time) { return cubic(time) - log_level; };
    const double first = above(from.time);
    const double last = above(to.time);
    // Not of samples out of order, as messages may have them.
    if (from.time < to.time && first * last < 0.0) {
      constexpr int kBits = 50;
      std::uintmax_t most_steps = 100;
      const auto [low, high] = boost::math::tools::toms748_solve(
          above, from.time, to.time, first, last, boost::math::tools::eps_tolerance<double>(kBits),
          most_steps);
      return 0.5 * (low + high);
    }
  }
  return from.time + length * std::log(level / from.force) / std::log(to.force / from.force);
}

}  // namespace impact
