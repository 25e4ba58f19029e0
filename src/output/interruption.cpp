#include "output/interruption.hpp"

#include <atomic>
#include <csignal>

namespace impact {
namespace {

std::atomic<bool> signal_received{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait");

}  // namespace

void take_interruptions() {
  std::signal(SIGINT, [](int) { signal_received = true; });
  std::signal(SIGTERM, [](int) { signal_received = true; });
}

bool interrupted() { return signal_received; }

}  // namespace impact
