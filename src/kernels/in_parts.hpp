#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <functional>

#include "kernels/kernels.hpp"
#include "kernels/threads.hpp"

namespace impact {

/// With fewer parts than this the other threads do not pay (test/bench/bench_runs.cpp).
constexpr Eigen::Index kFewestParts = 64;

inline Eigen::Index parts_of(Eigen::Index points) { return (points + kPart - 1) / kPart; }

/// Calls work(part, first, size) for each part of the points, kPart of them or what is left, on
/// several threads from kFewestParts parts on. What is summed up by parts is the same for any
/// number of threads.
template <class Work>
void in_parts(Eigen::Index points, const Work& work) {
  const Eigen::Index parts = parts_of(points);
  const auto do_part = [&](Eigen::Index part) {
    const Eigen::Index first = part * kPart;
    work(part, first, std::min<Eigen::Index>(kPart, points - first));
  };
  const int threads = parts < kFewestParts ? 1 : threads_in_a_run();
  if (threads == 1) {
    for (Eigen::Index part = 0; part < parts; ++part) do_part(part);
  } else {
    share_out(parts, threads, std::cref(do_part));
  }
}

}  // namespace impact
