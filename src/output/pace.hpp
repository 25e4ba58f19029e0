#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace impact {

/// How fast something goes on and when it will be done, by what was done since the first call.
class Pace {
 public:
  using Clock = std::chrono::steady_clock;

  /// `unit`: of what is done, as in "37 %, 540 states/s, 12 s left".
  explicit Pace(std::string unit) : unit_(std::move(unit)) {}

  /// The total may change.
  void note(double done, double total, Clock::time_point now = Clock::now());

  /// "37 %, 540 states/s, 12 s left"; without rate and time as long as they are not known.
  std::string text() const;

  double share() const;  ///< 0 … 1

 private:
  std::string unit_;
  double done_ = 0.0;
  double total_ = 0.0;
  std::optional<double> done_at_start_;
  Clock::time_point start_;
  Clock::time_point now_;
};

}  // namespace impact
