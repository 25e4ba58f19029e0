#include "output/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace impact {
namespace {

constexpr std::chrono::milliseconds kRedraw{200};
constexpr std::chrono::seconds kNextLine{10};
constexpr int kWidth = 20;

}  // namespace

ProgressLine::ProgressLine(std::string program, std::string unit)
    : program_(std::move(program)),
      pace_(std::move(unit)),
      on_terminal_(isatty(STDERR_FILENO) != 0),
      last_(on_terminal_ ? Clock::time_point() : Clock::now()) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::clear() const {
  if (on_terminal_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(double done, double total, const std::string& what) {
  const Clock::time_point now = Clock::now();
  pace_.note(done, total, now);
  if (on_terminal_ ? now - last_ < kRedraw : now - last_ < kNextLine) return;
  last_ = now;
  draw(what);
}

void ProgressLine::draw(const std::string& what) const {
  if (!on_terminal_) {
    fmt::print(stderr, "{}: {}: {}\n", program_, what, pace_.text());
    return;
  }
  const std::string filled(static_cast<std::size_t>(kWidth * pace_.share()), '#');
  fmt::print(stderr, "\r[{:-<{}}] {}: {}\033[K", filled, kWidth, what, pace_.text());
}

void ProgressBar::show(std::size_t done) {
  line_.show(static_cast<double>(done), static_cast<double>(total_),
             fmt::format("{}/{} {}", done, total_, unit_));
}

}  // namespace impact
