#include "measure/contact_time.hpp"

#include <cmath>

namespace impact {

void ContactTime::add(const ForceSample& sample) {
  const Step step{last_, sample};
  last_ = sample;
  if (sample.force > peak_ || std::isnan(peak_)) {
    peak_ = sample.force;
    rise_.push_back(step);
    while (rise_.front().second.force <= threshold() && rise_.size() > 1) rise_.pop_front();
  }
  if (step.first.force > threshold()) fall_ = step;
}

double ContactTime::begin() const { return peak_ > 0.0 ? crossing(rise_.front()) : kNaN; }

double ContactTime::end() const {
  return fall_.second.force <= threshold() ? crossing(fall_) : kNaN;
}

double ContactTime::crossing(const Step& step) const {
  const auto [before, after] = step;
  if (std::isnan(before.time)) return after.time;
  if (before.force <= 0.0 || after.force <= 0.0) {
    const double part = (threshold() - before.force) / (after.force - before.force);
    return before.time + part * (after.time - before.time);
  }
  const double part = std::log(threshold() / before.force) / std::log(after.force / before.force);
  return before.time + part * (after.time - before.time);
}

}  // namespace impact
