#include "nodes/progress_log.hpp"

#include <ros/console.h>

namespace impact {

void ProgressLog::note_states(double states, double expected_states) {
  pace_.note(states, expected_states);
  if (is_due()) ROS_INFO("%s: %s", name_.c_str(), pace_.text().c_str());
}

void ProgressLog::note_search() {
  if (!is_due()) return;
  const double spent = std::chrono::duration<double>(last_ - start_).count();
  ROS_INFO("%s: looking for the step that keeps numerics.error, %.0f s so far", name_.c_str(),
           spent);
}

bool ProgressLog::is_due() {
  constexpr std::chrono::seconds kInterval{5};
  const Pace::Clock::time_point now = Pace::Clock::now();
  if (now - last_ < kInterval) return false;
  last_ = now;
  return true;
}

}  // namespace impact
