#pragma once

#include <cstdint>
#include <string>

#include "output/pace.hpp"

namespace impact {

/// Logs every few seconds how far a run of a series is.
class ProgressLog {
 public:
  /// `name`: of the run, in words.
  explicit ProgressLog(std::string name) : name_(std::move(name)) {}

  /// So many states of about so many were published.
  void note_states(double states, double expected_states);
  /// The step that keeps the wanted error is being looked for.
  void note_search();

 private:
  bool is_due();

  std::string name_;
  Pace pace_{"states"};
  Pace::Clock::time_point start_ = Pace::Clock::now();
  Pace::Clock::time_point last_ = start_;
};

}  // namespace impact
