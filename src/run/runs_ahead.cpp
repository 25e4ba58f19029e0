#include "run/runs_ahead.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "kernels/in_parts.hpp"
#include "kernels/threads.hpp"

namespace impact {

RunsAhead::~RunsAhead() {
  for (const Ahead& ahead : ahead_) *ahead.given_up = true;
}

void RunsAhead::begin(const Resolution& present, const std::vector<Resolution>& later) {
  const Eigen::Index points = composition_->initial.position.rows();
  if (scene_.kind != SceneKind::kCollision || parts_of(points) >= kFewestParts) return;
  give_up_all_but(present, later);
  const auto others = static_cast<std::size_t>(threads_of_a_run() - 1);
  for (auto last = later.rbegin(); last != later.rend() && ahead_.size() < others; ++last) {
    if (find(*last) == ahead_.end()) begin_one(*last);
  }
}

void RunsAhead::give_up_all_but(const Resolution& present, const std::vector<Resolution>& later) {
  const auto is_wanted = [&](const Ahead& ahead) {
    return ahead.resolution == present ||
           std::find(later.begin(), later.end(), ahead.resolution) != later.end();
  };
  const auto unwanted = std::stable_partition(ahead_.begin(), ahead_.end(), is_wanted);
  std::for_each(unwanted, ahead_.end(), [](const Ahead& ahead) { *ahead.given_up = true; });
  ahead_.erase(unwanted, ahead_.end());
}

void RunsAhead::begin_one(const Resolution& resolution) {
  auto given_up = std::make_shared<std::atomic<bool>>(false);
  try {
    std::packaged_task<std::optional<Run>()> work(
        [this, resolution, given_up] { return make(resolution, *given_up); });
    std::future<std::optional<Run>> run = work.get_future();
    ahead_.push_back(
        {resolution, std::move(given_up), std::move(run), begin_elsewhere(std::move(work))});
  } catch (const std::system_error&) {  // no thread is to be had: it is made when it is asked for
  }
}

std::optional<Run> RunsAhead::make(const Resolution& resolution,
                                   const std::atomic<bool>& given_up) const {
  threads_in_a_run() = 1;
  Run run(scene_, composition_, resolution);
  try {
    while (!run.finished() && !given_up) run.advance([&] { return given_up.load(); });
  } catch (const RunFailure&) {
    return std::nullopt;
  }
  if (!run.finished()) return std::nullopt;
  return run;
}

void RunsAhead::wait_for(const Resolution& resolution, const std::function<bool()>& stop) {
  constexpr std::chrono::milliseconds kPatience{20};
  const auto begun = find(resolution);
  if (begun == ahead_.end()) return;
  while (begun->run.wait_for(kPatience) != std::future_status::ready) {
    if (stop && stop()) *begun->given_up = true;
  }
}

Run RunsAhead::take(const Resolution& resolution, const std::function<bool()>& stop) {
  wait_for(resolution, stop);
  std::optional<Run> run;
  if (const auto begun = find(resolution); begun != ahead_.end()) {
    std::future<std::optional<Run>> ended = std::move(begun->run);
    ahead_.erase(begun);
    run = ended.get();
  }
  return run ? std::move(*run) : Run(scene_, composition_, resolution);
}

std::vector<RunsAhead::Ahead>::iterator RunsAhead::find(const Resolution& resolution) {
  return std::find_if(ahead_.begin(), ahead_.end(),
                      [&](const Ahead& ahead) { return ahead.resolution == resolution; });
}

}  // namespace impact
