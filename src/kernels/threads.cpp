#include "kernels/threads.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace impact {

void share_out(Eigen::Index count, int threads, const std::function<void(Eigen::Index)>& work) {
  const auto on_all = [&] { tbb::parallel_for(Eigen::Index{0}, count, work); };
  if (threads == 0) {
    on_all();
  } else {
    tbb::task_arena(std::min(threads, tbb::this_task_arena::max_concurrency())).execute(on_all);
  }
}

}  // namespace impact
