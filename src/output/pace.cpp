#include "output/pace.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace impact {
namespace {

std::string time_left(double seconds) {
  constexpr double kMinute = 60.0;
  constexpr double kHour = 3600.0;
  constexpr double kMany = 100.0;  // of a unit: the next one is shown
  if (seconds < kMany) return fmt::format("{:.0f} s left", seconds);
  if (seconds < kMany * kMinute) return fmt::format("{:.0f} min left", seconds / kMinute);
  return fmt::format("{:.1f} h left", seconds / kHour);
}

std::string rate_text(double rate) {
  constexpr double kPlain = 100.0;
  return rate < kPlain ? fmt::format("{:.2g}", rate) : fmt::format("{:.0f}", rate);
}

}  // namespace

void Pace::note(double done, double total, Clock::time_point now) {
  if (!done_at_start_) {
    done_at_start_ = done;
    start_ = now;
  }
  done_ = done;
  total_ = total;
  now_ = now;
}

double Pace::share() const { return total_ > 0.0 ? std::clamp(done_ / total_, 0.0, 1.0) : 0.0; }

std::string Pace::text() const {
  constexpr double kLeast = 0.2;  // s that show a rate
  std::string per_cent = fmt::format("{:.0f} %", 100.0 * share());
  const double elapsed = std::chrono::duration<double>(now_ - start_).count();
  const double here = done_ - done_at_start_.value_or(done_);
  if (elapsed < kLeast || here <= 0.0) return per_cent;
  const double rate = here / elapsed;
  return fmt::format("{}, {} {}/s, {}", per_cent, rate_text(rate), unit_,
                     time_left(std::max(0.0, total_ - done_) / rate));
}

}  // namespace impact
