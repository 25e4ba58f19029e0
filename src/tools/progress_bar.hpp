#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

namespace impact {

/// Progress on stderr, if that is a terminal: a bar, runs done of all, per cent, time left.
class ProgressBar {
 public:
  explicit ProgressBar(std::size_t total) : total_(total) {}
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  /// Leaves an empty line.
  ~ProgressBar();

  /// Redraws at most five times a second. The time left follows from what was done since the first
  /// call.
  void show(std::size_t done);

 private:
  using Clock = std::chrono::steady_clock;

  void draw(std::size_t done) const;

  std::size_t total_;
  std::optional<std::size_t> done_at_start_;
  Clock::time_point start_;
  Clock::time_point last_drawing_;
};

}  // namespace impact
