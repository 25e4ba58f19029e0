#pragma once

namespace impact {

/// On how many threads the loops over the points of one run are shared out, in runs that the
/// calling thread makes. 0: on as many as OpenMP has, all processors that the program may use or
/// OMP_NUM_THREADS.
inline int& threads_in_a_run() {
  thread_local int threads = 0;
  return threads;
}

}  // namespace impact
