#include "tools/series.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/asio/use_future.hpp>
#include <chrono>
#include <deque>
#include <future>
#include <memory>
#include <utility>

#include "run/compose.hpp"
#include "run/energy_monitor.hpp"
#include "tools/experiment.hpp"

namespace impact {
namespace {

constexpr std::chrono::milliseconds kPatience{100};

std::string text(const YAML::Node& value) {
  if (value.IsScalar()) return value.Scalar();
  return fmt::format("{}", fmt::join(value.as<std::vector<std::string>>(), ";"));
}

using Scenes = std::vector<Scene>::const_iterator;

/// The end of the chain of scenes that begins here, each to be found from the one before.
Scenes end_of_chain(Scenes begin, Scenes end) {
  auto last = begin;
  for (auto next = begin + 1; next != end && is_next_load(*last, *next); ++next) last = next;
  return last + 1;
}

ResultTexts texts_of(const Experiment& experiment) {
  ResultTexts texts;
  for (const auto& entry : experiment.result()) texts[entry.first.Scalar()] = text(entry.second);
  return texts;
}

/// From the last answer or, where there is none or it has flags (folded), from the beginning.
void go_on(Experiment& experiment, const Scene& next) {
  if (experiment.finished() && experiment.run().flags().empty()) {
    experiment.go_on_to(next);
  } else {
    experiment = Experiment(next);
  }
}

using SharedComposition = std::shared_ptr<const Composition>;

/// Fewer results than scenes when it was told to stop. `composition`: of the first scene; null: not
/// made yet.
std::vector<ResultTexts> simulate(Scenes begin, Scenes end, SharedComposition composition,
                                  const std::function<bool()>& stop) {
  std::vector<ResultTexts> results;
  Experiment experiment(*begin, composition ? std::move(composition) : compose_shared(*begin));
  for (auto scene = begin; scene != end; ++scene) {
    if (scene != begin) go_on(experiment, *scene);
    try {
      while (!experiment.finished()) {
        if (stop()) return results;
        experiment.advance(stop);
      }
      results.push_back(texts_of(experiment));
    } catch (const RunFailure& error) {
      results.push_back(failure(error.what()));
    }
  }
  return results;
}

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

  std::future<std::vector<ResultTexts>> start(Scenes begin, Scenes end,
                                              SharedComposition composition) {
    return boost::asio::post(
        pool_,
        boost::asio::use_future([this, begin, end, composition = std::move(composition)]() mutable {
          return simulate(begin, end, std::move(composition), [this] { return stopped(); });
        }));
  }

 private:
  std::function<bool()> stop_;
  std::atomic<bool> given_up_{false};
  boost::asio::thread_pool pool_;
};

void break_off_if_stopped(const Workers& workers, const SeriesFile& file) {
  if (!workers.stopped()) return;
  throw std::runtime_error(
      fmt::format("interrupted after {} of {} runs; the same command goes on from there",
                  file.rows().size(), file.scenes().size()));
}

/// Scenes that one thread simulates, one after another.
struct Chain {
  Scenes begin;
  Scenes end;
  std::future<std::vector<ResultTexts>> results;
};

/// The chains of which rows are missing. One of which some rows are there is simulated from its
/// beginning again, so that the others do not depend on an interruption.
std::deque<Chain> missing_chains(const SeriesFile& file) {
  std::deque<Chain> chains;
  const std::vector<Scene>& scenes = file.scenes();
  for (auto begin = scenes.begin(); begin != scenes.end(); begin = chains.back().end) {
    chains.push_back({begin, end_of_chain(begin, scenes.end()), {}});
  }
  const auto first_missing = scenes.begin() + static_cast<std::ptrdiff_t>(file.rows().size());
  while (!chains.empty() && chains.front().end <= first_missing) chains.pop_front();
  return chains;
}

/// `first`: the composition with which the first chain begins.
void simulate_chains(std::deque<Chain> chains, SharedComposition first, SeriesFile& file,
                     const SeriesOptions& options) {
  const auto show_progress = [&] {
    if (options.progress) options.progress(file.rows().size());
  };
  Workers workers(options.jobs, options.stop);
  for (Chain& chain : chains) {
    chain.results = workers.start(chain.begin, chain.end, std::exchange(first, nullptr));
  }
  const auto first_missing =
      file.scenes().begin() + static_cast<std::ptrdiff_t>(file.rows().size());
  for (Chain& chain : chains) {
    do {
      show_progress();
      break_off_if_stopped(workers, file);
    } while (chain.results.wait_for(kPatience) != std::future_status::ready);
    const std::vector<ResultTexts> results = chain.results.get();
    break_off_if_stopped(workers, file);
    const auto known = std::max<std::ptrdiff_t>(0, first_missing - chain.begin);
    std::for_each(results.begin() + known, results.end(),
                  [&](const ResultTexts& texts) { file.append(texts); });
  }
  show_progress();
}

}  // namespace

std::vector<Row> run_series(const std::vector<Scene>& scenes, const std::filesystem::path& file,
                            const SeriesOptions& options) {
  SeriesFile rows(file, scenes);
  std::deque<Chain> chains = missing_chains(rows);
  if (!chains.empty()) {
    SharedComposition first = compose_shared(*chains.front().begin);
    rows.open();
    simulate_chains(std::move(chains), std::move(first), rows, options);
  }
  return rows.rows();
}

}  // namespace impact
