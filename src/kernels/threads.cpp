#include "kernels/threads.hpp"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <utility>

namespace impact {
namespace {

/// That the program may use when it first asks.
int processors() {
  static const int count = [] {
    cpu_set_t allowed;
    return sched_getaffinity(0, sizeof(allowed), &allowed) == 0 ? CPU_COUNT(&allowed) : 1;
  }();
  return count;
}

/// The pieces of one call, which the calling thread and helpers take in turn. A helper may come
/// when all is done and the call is over, so it keeps the job alive, but no longer the work.
class Job {
 public:
  Job(Eigen::Index count, const std::function<void(Eigen::Index)>& work)
      : count_(count), work_(work) {}

  void help() {
    {
      const std::lock_guard lock(mutex_);
      if (over_) return;
      ++helpers_;
    }
    take_pieces();
    const std::lock_guard lock(mutex_);
    if (--helpers_ == 0) left_.notify_one();
  }

  /// Does what nobody else has taken, and waits for the helpers that are at work.
  void finish() {
    take_pieces();
    std::unique_lock lock(mutex_);
    over_ = true;
    left_.wait(lock, [this] { return helpers_ == 0; });
    // Not shared with a helper that comes late and would be the one to destroy it.
    if (failure_) std::rethrow_exception(std::move(failure_));
  }

 private:
  void take_pieces() {
    try {
      for (Eigen::Index k = next_++; k < count_; k = next_++) work_(k);
    } catch (...) {
      next_ = count_;
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }

  const Eigen::Index count_;
  const std::function<void(Eigen::Index)>& work_;
  std::atomic<Eigen::Index> next_{0};
  std::mutex mutex_;
  std::condition_variable left_;
  int helpers_ = 0;
  bool over_ = false;
  std::exception_ptr failure_;
};

}  // namespace

int threads_of_a_run() {
  const int threads = threads_in_a_run();
  return threads == 0 ? processors() : std::min(threads, processors());
}

void share_out(Eigen::Index count, int threads, const std::function<void(Eigen::Index)>& work) {
  const Eigen::Index helpers =
      std::min<Eigen::Index>(threads == 0 ? processors() : std::min(threads, processors()), count) -
      1;
  const auto job = std::make_shared<Job>(count, work);
  if (helpers > 0) {
    static boost::asio::thread_pool pool(static_cast<std::size_t>(processors() - 1));
    for (Eigen::Index k = 0; k < helpers; ++k) boost::asio::post(pool, [job] { job->help(); });
  }
  job->finish();
}

void JoinAndDelete::operator()(std::thread* thread) const {
  thread->join();
  delete thread;
}

void send_away(std::thread& thread) {
  cpu_set_t allowed;
  if (pthread_getaffinity_np(pthread_self(), sizeof(allowed), &allowed) != 0) return;
  cpu_set_t others = allowed;
  CPU_CLR(sched_getcpu(), &others);
  if (CPU_COUNT(&others) == 0) return;
  pthread_setaffinity_np(thread.native_handle(), sizeof(others), &others);
  pthread_setaffinity_np(thread.native_handle(), sizeof(allowed), &allowed);
}

}  // namespace impact
