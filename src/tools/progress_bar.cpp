#include "tools/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace impact {
namespace {

constexpr std::chrono::milliseconds kRedraw{200};
constexpr std::size_t kWidth = 30;

std::string time_left(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.0f} s left", seconds);
  if (seconds < 6000.0) return fmt::format("{:.0f} min left", seconds / 60.0);
  return fmt::format("{:.1f} h left", seconds / 3600.0);
}

bool is_shown() { return isatty(STDERR_FILENO) != 0; }

}  // namespace

ProgressBar::~ProgressBar() {
  if (is_shown()) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(std::size_t done) {
  const Clock::time_point now = Clock::now();
  if (!done_at_start_) {
    done_at_start_ = done;
    start_ = now;
  }
  if (!is_shown() || now - last_drawing_ < kRedraw) return;
  last_drawing_ = now;
  draw(done);
}

void ProgressBar::draw(std::size_t done) const {
  const std::size_t done_here = done - *done_at_start_;
  const double elapsed = std::chrono::duration<double>(last_drawing_ - start_).count();
  const double left = elapsed * static_cast<double>(total_ - done) / static_cast<double>(done_here);
  fmt::print(stderr, "\r[{:-<{}}] {}/{}, {} %{}\033[K", std::string(kWidth * done / total_, '#'),
             kWidth, done, total_, 100 * done / total_,
             done_here == 0 ? "" : ", " + time_left(left));
}

}  // namespace impact
