#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

namespace impact {

/// On how many threads an answer is worked out that the calling thread asks for: the loops over the
/// points of a large run, or several runs. 0: on as many as there are processors that the program
/// may use.
inline int& threads_in_a_run() {
  thread_local int threads = 0;
  return threads;
}

/// threads_in_a_run(), as far as there are processors.
int threads_of_a_run();

/// Calls work(0) … work(count − 1) on several threads, of which the calling one is one; the others
/// live as long as the program. Each takes the next piece of work when it is free and sleeps when
/// there is none. So a thread that other programs slow down does less, and waiting costs no
/// processor time.
/// @param threads at most so many; 0: as threads_in_a_run().
/// @throw the first exception that `work` throws, when no piece is being worked on any more; the
/// pieces that nobody has begun are left out.
void share_out(Eigen::Index count, int threads, const std::function<void(Eigen::Index)>& work);

struct JoinAndDelete {
  void operator()(std::thread* thread) const;
};

/// Waited for when its owner lets go of it.
using JoinedThread = std::unique_ptr<std::thread, JoinAndDelete>;

/// Where the thread waits behind the calling one, lets it begin on another processor that the
/// program may use. A kernel does not always see to that: on virtual machines Linux takes a
/// processor that is halted for a busy one, so that a new thread waits for a time slice, some
/// milliseconds, while the processor beside it is idle.
void send_away(std::thread& thread);

/// A thread that begins with `work` at once, where a processor is free.
/// @throw std::system_error when no thread is to be had
template <class Work>
JoinedThread begin_elsewhere(Work work) {
  JoinedThread thread(new std::thread(std::move(work)));
  send_away(*thread);
  return thread;
}

}  // namespace impact
