#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <vector>

#include "kernels/kernels.hpp"
#include "kernels/threads.hpp"

namespace impact {

/// With fewer parts than this the other threads do not pay (test/bench/bench_runs.cpp).
constexpr Eigen::Index kFewestParts = 64;

inline Eigen::Index parts_of(Eigen::Index points) { return (points + kPart - 1) / kPart; }

/// Successive rows of points.
struct PointRows {
  Eigen::Index first;
  Eigen::Index size;
};

inline PointRows rows_of_part(Eigen::Index part, Eigen::Index points) {
  const Eigen::Index first = part * kPart;
  return {first, std::min<Eigen::Index>(kPart, points - first)};
}

/// On how many threads loops over so many parts are shared out; 0: on all.
inline int threads_for(Eigen::Index parts) { return parts < kFewestParts ? 1 : threads_in_a_run(); }

/// Calls work(0) … work(count − 1), on several threads where there are so many parts.
template <class Work>
void share_out_in_run(Eigen::Index count, Eigen::Index parts, const Work& work) {
  const int threads = threads_for(parts);
  if (threads == 1) {
    for (Eigen::Index k = 0; k < count; ++k) work(k);
  } else {
    share_out(count, threads, std::cref(work));
  }
}

/// Calls work(part, first, size) for each part of the points, kPart of them or what is left, on
/// several threads from kFewestParts parts on. What is summed up by parts is the same for any
/// number of threads.
template <class Work>
void in_parts(Eigen::Index points, const Work& work) {
  const Eigen::Index parts = parts_of(points);
  share_out_in_run(parts, parts, [&](Eigen::Index part) {
    const PointRows rows = rows_of_part(part, points);
    work(part, rows.first, rows.size);
  });
}

/// The parts that have to be in place before one can be worked on.
struct PartsNeeded {
  std::vector<Eigen::Index> begin;  ///< the first for any part from this one on
  std::vector<Eigen::Index> end;    ///< after the last for any part up to this one
};

/// Goes through the parts of the points once, so that what is done to one finds it in the cache:
/// calls place(part) for each, and work(part) after that of all parts which it needs. On several
/// threads each goes through some stretches of parts, once those on both sides of all joints are in
/// place.
template <class Place, class Work>
void in_passing(Eigen::Index parts, const PartsNeeded& needed, const Place& place,
                const Work& work) {
  constexpr Eigen::Index kStretches = 16;
  const Eigen::Index stretches = threads_for(parts) == 1 ? 1 : kStretches;
  const auto begin_of = [&](Eigen::Index stretch) { return parts * stretch / stretches; };
  const auto needed_from = [&](Eigen::Index joint) {
    const Eigen::Index part = begin_of(joint);
    return part < parts ? std::min(part, needed.begin[static_cast<std::size_t>(part)]) : parts;
  };
  const auto needed_to = [&](Eigen::Index joint) {
    const Eigen::Index part = begin_of(joint);
    return part > 0 ? std::max(part, needed.end[static_cast<std::size_t>(part) - 1]) : 0;
  };
  share_out_in_run(stretches - 1, parts, [&](Eigen::Index k) {
    const Eigen::Index joint = k + 1;
    const Eigen::Index begin = std::max(needed_from(joint), needed_to(joint - 1));
    for (Eigen::Index part = begin; part < needed_to(joint); ++part) place(part);
  });
  share_out_in_run(stretches, parts, [&](Eigen::Index stretch) {
    Eigen::Index placed = needed_to(stretch);
    const Eigen::Index own_end = needed_from(stretch + 1);
    for (Eigen::Index part = begin_of(stretch); part < begin_of(stretch + 1); ++part) {
      const Eigen::Index end = std::min(own_end, needed.end[static_cast<std::size_t>(part)]);
      for (; placed < end; ++placed) place(placed);
      work(part);
    }
    for (; placed < own_end; ++placed) place(placed);
  });
}

}  // namespace impact
