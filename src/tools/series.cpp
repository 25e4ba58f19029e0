#include "tools/series.hpp"

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

#include "mechanics/threads.hpp"
#include "run/compose.hpp"
#include "run/energy_monitor.hpp"
#include "tools/experiment.hpp"
#include "tools/side_by_side.hpp"

namespace impact {
namespace {

constexpr std::chrono::milliseconds kPatience{100};

/// From the last answer or, where there is none or it has flags (folded), from the beginning.
void go_on(Experiment& experiment, const Scene& next) {
  if (experiment.finished() && experiment.run().flags().empty()) {
    experiment.go_on_to(next);
  } else {
    experiment = Experiment(next);
  }
}

using SharedComposition = std::shared_ptr<const Composition>;

/// One after another, each from the one before. Nothing when it was told to stop. `composition`: of
/// the first scene; null: not made yet.
std::optional<SeriesOutcome> simulate_chain(const std::vector<Scene>& scenes,
                                            SharedComposition composition,
                                            const std::function<bool()>& stop,
                                            const std::function<void()>& done) {
  SeriesOutcome outcome;
  Experiment experiment(scenes.front(),
                        composition ? std::move(composition) : compose_shared(scenes.front()));
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (i > 0) go_on(experiment, scenes[i]);
    try {
      while (!experiment.finished()) {
        if (stop()) return std::nullopt;
        experiment.advance(stop);
      }
      outcome.results.push_back(texts_of(experiment));
    } catch (const RunFailure& error) {
      outcome.results.push_back(failure(error.what()));
    }
    done();
  }
  return outcome;
}

/// Scenes that one thread simulates.
struct Task {
  bool in_lanes;
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

  std::future<std::optional<SeriesOutcome>> start(bool in_lanes, std::vector<Scene> scenes,
                                                  SharedComposition composition) {
    return boost::asio::post(
        pool_, boost::asio::use_future([this, in_lanes, scenes = std::move(scenes),
                                        composition = std::move(composition)]() mutable {
          threads_in_a_run() = 1;
          const std::function<bool()> stop = [this] { return stopped(); };
          const std::function<void()> done = [this] { ++done_; };
          return in_lanes ? simulate_side_by_side(scenes, stop, done)
                          : simulate_chain(scenes, std::move(composition), stop, done);
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

/// The scenes that go into lanes: those whose bodies so many have that lanes pay. By their bodies.
std::map<std::string, std::vector<std::size_t>> sharing_bodies(const std::vector<Scene>& scenes) {
  constexpr std::size_t kFewest = 3;
  std::map<std::string, std::vector<std::size_t>> groups;
  for (std::size_t row = 0; row < scenes.size(); ++row) {
    if (can_be_in_lanes(scenes[row])) groups[key_of_bodies(scenes[row])].push_back(row);
  }
  for (auto group = groups.begin(); group != groups.end();) {
    group = group->second.size() < kFewest ? groups.erase(group) : std::next(group);
  }
  return groups;
}

/// How many scenes of one group a task takes: enough that lanes are seldom empty, not so many that
/// a thread has none, nor that they fill the memory.
std::size_t most_in_task(const Scene& scene, std::size_t scenes, int jobs) {
  constexpr std::size_t kMost = 96;
  constexpr std::size_t kMostPoints = 200000;  // in all
  const std::size_t share =
      (scenes + static_cast<std::size_t>(jobs) - 1) / static_cast<std::size_t>(jobs);
  const std::size_t by_points = kMostPoints / static_cast<std::size_t>(scene.disk.recipe.points);
  return std::max<std::size_t>(kLanes, std::min({kMost, by_points, share}));
}

/// The tasks of which rows are missing, in the order of their first rows. A chain of which some
/// rows are there is simulated from its beginning again, so that the others do not depend on an
/// interruption.
std::vector<Task> missing_tasks(const SeriesFile& file, int jobs) {
  const std::vector<Scene>& scenes = file.scenes();
  const std::size_t known = file.rows().size();
  std::vector<Task> tasks;
  std::vector<bool> taken(scenes.size(), false);
  const auto groups = sharing_bodies(scenes);
  const std::size_t in_lanes =
      std::accumulate(groups.begin(), groups.end(), std::size_t{0},
                      [](std::size_t sum, const auto& group) { return sum + group.second.size(); });
  for (const auto& [key, rows] : groups) {
    const std::size_t most = most_in_task(scenes[rows.front()], in_lanes, jobs);
    for (const std::size_t row : rows) {
      taken[row] = true;
      if (row < known) continue;
      if (tasks.empty() || !tasks.back().in_lanes || tasks.back().rows.size() == most ||
          key_of_bodies(scenes[tasks.back().rows.front()]) != key) {
        tasks.push_back({true, {}});
      }
      tasks.back().rows.push_back(row);
    }
  }
  for (std::size_t row = 0; row < scenes.size(); ++row) {
    if (taken[row]) continue;
    Task chain{false, {row}};
    while (row + 1 < scenes.size() && is_next_load(scenes[row], scenes[row + 1])) {
      chain.rows.push_back(++row);
    }
    if (chain.rows.back() >= known) tasks.push_back(std::move(chain));
  }
  std::sort(tasks.begin(), tasks.end(),
            [](const Task& a, const Task& b) { return a.rows.front() < b.rows.front(); });
  return tasks;
}

/// Writes rows in their order as soon as it can.
class InOrder {
 public:
  explicit InOrder(SeriesFile& file) : file_(file) {}

  void take(const Task& task, std::vector<ResultTexts> results) {
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
  std::map<std::size_t, ResultTexts> waiting_;
};

/// `first`: the composition of the first scene of the first task.
void simulate_tasks(std::vector<Task> tasks, SharedComposition first, SeriesFile& file,
                    const SeriesOptions& options) {
  const std::size_t known = file.rows().size();
  Workers workers(options.jobs, options.stop);
  const auto show_progress = [&] {
    if (!options.progress) return;
    options.progress(file.rows().size(), std::min(known + workers.done(), file.scenes().size()));
  };
  for (Task& task : tasks) {
    std::vector<Scene> scenes;
    for (const std::size_t row : task.rows) scenes.push_back(file.scenes()[row]);
    task.outcome = workers.start(task.in_lanes, std::move(scenes), std::exchange(first, nullptr));
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
  SeriesFile rows(file, scenes);
  std::vector<Task> tasks = missing_tasks(rows, options.jobs);
  if (!tasks.empty()) {
    SharedComposition first = compose_shared(scenes[tasks.front().rows.front()]);
    rows.open();
    simulate_tasks(std::move(tasks), std::move(first), rows, options);
  }
  return rows.rows();
}

}  // namespace impact
