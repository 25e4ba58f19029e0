#include "series/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/asio/use_future.hpp>
#include <chrono>
#include <exception>
#include <future>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "kernels/threads.hpp"
#include "run/compose.hpp"
#include "run/energy_monitor.hpp"
#include "series/convergence_study.hpp"
#include "series/side_by_side.hpp"

namespace impact {
namespace {

constexpr std::chrono::milliseconds kPatience{100};

using SharedBodies = std::shared_ptr<const Bodies>;

/// Nothing when it was told to stop.
std::optional<SeriesOutcome> simulate(const Scene& scene, SharedBodies bodies,
                                      const std::function<bool()>& stop,
                                      const std::function<void()>& done) {
  ConvergenceStudy study(scene,
                         std::make_shared<const Composition>(compose(scene, std::move(bodies))));
  SeriesOutcome outcome;
  try {
    while (!study.finished()) {
      if (stop()) return std::nullopt;
      study.advance(stop);
    }
    outcome.results.push_back(study.result());
  } catch (const RunFailure& error) {
    outcome.results.push_back(failure(error.what()));
  }
  done();
  return outcome;
}

/// Scenes that one thread simulates: one, or some of the same bodies that can be in lanes.
struct Task {
  std::vector<std::size_t> rows;  ///< of the scenes, rising
  std::future<std::optional<SeriesOutcome>> outcome{};
};

/// Simulates scenes on several threads; what is not done at the end of its life is given up.
class Workers {
 public:
  Workers(int jobs, std::function<bool()> stop)
      : stop_(std::move(stop)), pool_(static_cast<std::size_t>(jobs)) {}
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers() {
    given_up_ = true;
    pool_.stop();
    pool_.join();
  }

  bool stopped() const { return given_up_ || (stop_ && stop_()); }
  std::size_t done() const { return done_; }

  /// `bodies`: of the scenes; nullptr: not made yet.
  std::future<std::optional<SeriesOutcome>> start(std::vector<Scene> scenes, SharedBodies bodies) {
    return boost::asio::post(
        pool_, boost::asio::use_future([this, scenes = std::move(scenes),
                                        bodies = std::move(bodies)]() mutable {
          threads_in_a_run() = 1;
          const std::function<bool()> stop = [this] { return stopped(); };
          const std::function<void()> done = [this] { ++done_; };
          if (!bodies) bodies = make_common_bodies(scenes);
          return scenes.size() == 1 ? simulate(scenes.front(), std::move(bodies), stop, done)
                                    : simulate_side_by_side(scenes, std::move(bodies), stop, done);
        }));
  }

 private:
  std::function<bool()> stop_;
  std::atomic<bool> given_up_{false};
  std::atomic<std::size_t> done_{0};
  boost::asio::thread_pool pool_;
};

void break_off_if_stopped(const Workers& workers, const SeriesFile& file) {
  if (!workers.stopped()) return;
  throw std::runtime_error(
      fmt::format("interrupted after {} of {} runs; the same command goes on from there",
                  file.rows().size(), file.scenes().size()));
}

/// Equal for scenes that can be simulated side by side if they can be in lanes at all.
std::string lane_group_key(const Scene& scene) {
  return (scene.is_static() ? "static " : "") + key_of_bodies(scene);
}

/// The scenes that go into lanes, by group: those in groups large enough for lanes to pay.
std::map<std::string, std::vector<std::size_t>> lane_groups(const std::vector<Scene>& scenes) {
  constexpr std::size_t kFewest = 3;
  std::map<std::string, std::vector<std::size_t>> groups;
  for (std::size_t row = 0; row < scenes.size(); ++row) {
    if (may_be_in_lanes(scenes[row])) groups[lane_group_key(scenes[row])].push_back(row);
  }
  for (auto group = groups.begin(); group != groups.end();) {
    group = group->second.size() < kFewest ? groups.erase(group) : std::next(group);
  }
  return groups;
}

/// How many scenes of one group a task takes: enough to keep the lanes full, but few enough to
/// leave work for every thread and to fit into memory.
std::size_t most_in_task(const Scene& scene, std::size_t scenes, int jobs) {
  constexpr std::size_t kMost = 96;
  constexpr std::size_t kMostPoints = 200000;  // in all
  const std::size_t share =
      (scenes + static_cast<std::size_t>(jobs) - 1) / static_cast<std::size_t>(jobs);
  const std::size_t by_points = kMostPoints / static_cast<std::size_t>(scene.disk.recipe.points);
  return std::max<std::size_t>(kLanes, std::min({kMost, by_points, share}));
}

/// The tasks for the rows that are missing, in the order of their first rows.
std::vector<Task> missing_tasks(const SeriesFile& file, int jobs) {
  const std::vector<Scene>& scenes = file.scenes();
  const std::size_t known = file.rows().size();
  std::vector<Task> tasks;
  std::vector<bool> taken(scenes.size(), false);
  const auto groups = lane_groups(scenes);
  const std::size_t in_lanes =
      std::accumulate(groups.begin(), groups.end(), std::size_t{0},
                      [](std::size_t sum, const auto& group) { return sum + group.second.size(); });
  for (const auto& [key, rows] : groups) {
    const std::size_t most = most_in_task(scenes[rows.front()], in_lanes, jobs);
    bool begins = true;
    for (const std::size_t row : rows) {
      taken[row] = true;
      if (row < known) continue;
      if (begins || tasks.back().rows.size() == most) tasks.emplace_back();
      tasks.back().rows.push_back(row);
      begins = false;
    }
  }
  for (std::size_t row = known; row < scenes.size(); ++row) {
    if (!taken[row]) tasks.push_back({{row}});
  }
  std::sort(tasks.begin(), tasks.end(),
            [](const Task& a, const Task& b) { return a.rows.front() < b.rows.front(); });
  return tasks;
}

/// Writes rows in their order as soon as it can.
class InOrder {
 public:
  explicit InOrder(SeriesFile& file) : file_(file) {}

  void take(const Task& task, std::vector<Result> results) {
    for (std::size_t i = 0; i < results.size(); ++i) {
      if (task.rows[i] >= file_.rows().size()) waiting_[task.rows[i]] = std::move(results[i]);
    }
    while (!waiting_.empty() && waiting_.begin()->first == file_.rows().size()) {
      file_.append(waiting_.begin()->second);
      waiting_.erase(waiting_.begin());
    }
  }

 private:
  SeriesFile& file_;
  std::map<std::size_t, Result> waiting_;
};

std::vector<Scene> scenes_of(const Task& task, const SeriesFile& file) {
  std::vector<Scene> scenes;
  for (const std::size_t row : task.rows) scenes.push_back(file.scenes()[row]);
  return scenes;
}

/// `first`: the bodies of the first task.
void simulate_tasks(std::vector<Task> tasks, SharedBodies first, SeriesFile& file,
                    const SeriesOptions& options) {
  const std::size_t known = file.rows().size();
  Workers workers(options.jobs, options.stop);
  const auto show_progress = [&] {
    if (!options.progress) return;
    options.progress(file.rows().size(), std::min(known + workers.done(), file.scenes().size()));
  };
  for (Task& task : tasks) {
    task.outcome = workers.start(scenes_of(task, file), std::exchange(first, nullptr));
  }
  InOrder rows(file);
  std::size_t end = file.scenes().size();
  std::exception_ptr error;
  for (Task& task : tasks) {
    if (task.rows.front() >= end) break;
    do {
      show_progress();
      break_off_if_stopped(workers, file);
    } while (task.outcome.wait_for(kPatience) != std::future_status::ready);
    std::optional<SeriesOutcome> outcome = task.outcome.get();
    break_off_if_stopped(workers, file);
    if (outcome->error && task.rows[outcome->results.size()] < end) {
      end = task.rows[outcome->results.size()];
      error = outcome->error;
    }
    rows.take(task, std::move(outcome->results));
  }
  if (error) std::rethrow_exception(error);
  show_progress();
}

}  // namespace

std::vector<Row> run_series(const std::vector<Scene>& scenes, const std::filesystem::path& file,
                            const SeriesOptions& options) {
  for (const Scene& scene : scenes) refuse_impossible(scene);
  return run_series(SeriesFile(file, scenes), options);
}

std::vector<Row> run_series(SeriesFile file, const SeriesOptions& options) {
  std::vector<Task> tasks = missing_tasks(file, options.jobs);
  if (!tasks.empty()) {
    const std::vector<Scene> first_scenes = scenes_of(tasks.front(), file);
    SharedBodies first = make_common_bodies(first_scenes);
    compose(first_scenes.front(), first);  // before a file is written
    file.open();
    simulate_tasks(std::move(tasks), std::move(first), file, options);
  }
  return file.rows();
}

}  // namespace impact
