#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "output/pace.hpp"

namespace impact {

/// Progress on stderr: to a terminal a line that is redrawn, else a line every ten seconds.
class ProgressLine {
 public:
  using Clock = Pace::Clock;

  /// `unit`: of what is done.
  ProgressLine(std::string program, std::string unit);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  /// Leaves an empty line.
  ~ProgressLine();

  /// To be called often. `what` is being done, in words.
  void show(double done, double total, const std::string& what);

  /// Empties a terminal's line, before something else is printed.
  void clear() const;

 private:
  void draw(const std::string& what) const;

  std::string program_;
  Pace pace_;
  bool on_terminal_;
  Clock::time_point last_;
};

/// Progress of so many runs, or what `unit` calls them.
class ProgressBar {
 public:
  ProgressBar(std::string program, std::size_t total, const std::string& unit = "runs")
      : line_(std::move(program), unit), total_(total), unit_(unit) {}

  /// The time left follows from what was done since the first call.
  void show(std::size_t done);
  void clear() const { line_.clear(); }

 private:
  ProgressLine line_;
  std::size_t total_;
  std::string unit_;
};

}  // namespace impact
