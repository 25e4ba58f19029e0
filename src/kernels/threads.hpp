#pragma once

#include <Eigen/Core>
#include <functional>

namespace impact {

/// On how many threads the loops over the points of one run are shared out, in runs that the
/// calling thread makes. 0: on as many as there are processors that the program may use.
inline int& threads_in_a_run() {
  thread_local int threads = 0;
  return threads;
}

/// Calls work(0) … work(count − 1) on several threads, of which the calling one is one; the others
/// live as long as the program. Each takes the next piece of work when it is free and sleeps when
/// there is none. So a thread that other programs slow down does less, and waiting costs no
/// processor time.
/// @param threads at most so many; 0: as threads_in_a_run().
/// @throw the first exception that `work` throws, when no piece is being worked on any more; the
/// pieces that nobody has begun are left out.
void share_out(Eigen::Index count, int threads, const std::function<void(Eigen::Index)>& work);

}  // namespace impact
