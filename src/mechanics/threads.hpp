#pragma once

#include <algorithm>
#include <thread>

namespace impact {

/// On how many threads the loops over the points of one run are shared out, in runs that the
/// calling thread makes. All processors, unless it says otherwise.
inline int& threads_in_a_run() {
  thread_local int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return threads;
}

}  // namespace impact
