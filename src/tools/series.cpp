#include "tools/series.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/asio/use_future.hpp>
#include <chrono>
#include <future>

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

/// Empty cells when it was told to stop.
ResultTexts simulate(const Scene& scene, const std::function<bool()>& stop) {
  Experiment experiment(scene);
  try {
    while (!experiment.finished()) {
      if (stop()) return {};
      experiment.advance(stop);
    }
  } catch (const RunFailure& error) {
    return failure(error.what());
  }
  ResultTexts texts;
  for (const auto& entry : experiment.result()) texts[entry.first.Scalar()] = text(entry.second);
  return texts;
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

  std::future<ResultTexts> start(const Scene& scene) {
    return boost::asio::post(pool_, boost::asio::use_future([this, &scene] {
                               return simulate(scene, [this] { return stopped(); });
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

void simulate_missing_rows(SeriesFile& file, const SeriesOptions& options) {
  const auto show_progress = [&] {
    if (options.progress) options.progress(file.rows().size());
  };
  Workers workers(options.jobs, options.stop);
  std::vector<std::future<ResultTexts>> results;
  for (std::size_t i = file.rows().size(); i < file.scenes().size(); ++i) {
    results.push_back(workers.start(file.scenes()[i]));
  }
  for (auto& result : results) {
    do {
      show_progress();
      break_off_if_stopped(workers, file);
    } while (result.wait_for(kPatience) != std::future_status::ready);
    const ResultTexts texts = result.get();
    break_off_if_stopped(workers, file);
    file.append(texts);
  }
  show_progress();
}

}  // namespace

std::vector<Row> run_series(const std::vector<Scene>& scenes, const std::filesystem::path& file,
                            const SeriesOptions& options) {
  SeriesFile rows(file, scenes);
  const std::size_t done = rows.rows().size();
  if (done < scenes.size()) {
    compose(scenes[done]);
    rows.open();
    simulate_missing_rows(rows, options);
  }
  return rows.rows();
}

}  // namespace impact
