#include "kernels/threads.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <future>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

namespace impact {
namespace {

using Eigen::Index;

std::vector<int> visits(Index count, int threads) {
  std::vector<int> visits(static_cast<std::size_t>(count), 0);
  share_out(count, threads, [&](Index k) { ++visits[static_cast<std::size_t>(k)]; });
  return visits;
}

bool covers_each_once(Index count, int threads) {
  return visits(count, threads) == std::vector<int>(static_cast<std::size_t>(count), 1);
}

TEST(ShareOut, CallsEachOnce) {
  for (const Index count : {0, 1, 2, 100}) {
    for (const int threads : {0, 1, 2, 100}) {
      EXPECT_TRUE(covers_each_once(count, threads)) << count << " on " << threads;
    }
  }
}

/// Helpers that come late to one call must leave the next one's pieces whole.
TEST(ShareOut, CallsEachOnceInManyShortCalls) {
  for (int call = 0; call < 5000; ++call) ASSERT_TRUE(covers_each_once(3, 0));
}

TEST(ShareOut, ServesSeveralThreadsAtOnce) {
  std::vector<std::future<bool>> callers(4);
  for (auto& caller : callers) {
    caller = std::async(std::launch::async, [] {
      bool good = true;
      for (int call = 0; call < 200; ++call) good = good && covers_each_once(50, 0);
      return good;
    });
  }
  for (auto& caller : callers) EXPECT_TRUE(caller.get());
}

TEST(ShareOut, MayBeCalledByAPieceOfWork) {
  std::atomic<int> calls{0};
  share_out(10, 0, [&](Index) { share_out(10, 0, [&](Index) { ++calls; }); });
  EXPECT_EQ(calls, 100);
}

/// Wherever the piece that fails is done, nobody is at work any more when the caller learns of it.
TEST(ShareOut, ThrowsWhatAPieceThrows) {
  for (int call = 0; call < 200; ++call) {
    std::atomic<int> at_work{0};
    const auto fail = [&](Index k) {
      ++at_work;
      std::this_thread::sleep_for(std::chrono::microseconds(50));
      --at_work;
      if (k == 3) throw std::runtime_error("the fourth");
    };
    try {
      share_out(10, 0, fail);
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "the fourth");
    }
    EXPECT_EQ(at_work, 0);
  }
  EXPECT_TRUE(covers_each_once(100, 0));
}

/// Threads that wait spend next to no processor time.
TEST(ShareOut, SleepsWhileItWaits) {
  const auto spent = [](Index count) {
    const std::clock_t start = std::clock();
    share_out(count, 0, [](Index k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(k == 0 ? 200 : 1));
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  };
  EXPECT_LT(spent(2), 0.1);
  EXPECT_LT(spent(100), 0.1);
}

std::vector<int> processors_of(pthread_t thread) {
  cpu_set_t allowed;
  EXPECT_EQ(pthread_getaffinity_np(thread, sizeof(allowed), &allowed), 0);
  std::vector<int> processors;
  for (int k = 0; k < CPU_SETSIZE; ++k) {
    if (CPU_ISSET(k, &allowed)) processors.push_back(k);
  }
  return processors;
}

/// It may go wherever its maker may, once it has begun, and so may its maker.
TEST(BeginElsewhere, LeavesAllProcessorsToBoth) {
  const std::vector<int> before = processors_of(pthread_self());
  std::promise<void> go_on;
  std::vector<int> own;
  {
    const JoinedThread thread = begin_elsewhere([&] {
      go_on.get_future().wait();
      own = processors_of(pthread_self());
    });
    go_on.set_value();
  }
  EXPECT_EQ(own, before);
  EXPECT_EQ(processors_of(pthread_self()), before);
}

/// Even one that was bound to the processor of its maker.
TEST(BeginElsewhere, FreesAThreadFromTheProcessorOfItsMaker) {
  const std::vector<int> all = processors_of(pthread_self());
  if (all.size() < 2) GTEST_SKIP() << "one processor";
  std::promise<void> go_on;
  std::vector<int> own;
  JoinedThread thread(new std::thread([&] {
    go_on.get_future().wait();
    own = processors_of(pthread_self());
  }));
  cpu_set_t here;
  CPU_ZERO(&here);
  CPU_SET(sched_getcpu(), &here);
  EXPECT_EQ(pthread_setaffinity_np(thread->native_handle(), sizeof(here), &here), 0);
  send_away(*thread);
  go_on.set_value();
  thread.reset();
  EXPECT_EQ(own, all);
}

}  // namespace
}  // namespace impact
