#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "output/interruption.hpp"
#include "output/program.hpp"
#include "output/progress_bar.hpp"
#include "output/text_table.hpp"
#include "run/forecast.hpp"
#include "series/shards.hpp"

namespace impact {

/// What a program does with the shards of its series.
struct Sharding {
  std::string shard{};  ///< K/N: simulate it; empty: no
  bool collect = false;
  bool status = false;
  Format format = Format::kAuto;  ///< of the status

  bool is_wanted() const { return status || collect || !shard.empty(); }
};

/// Adds --shard, --collect, --status and the formats of the latter.
inline void offer_shards(CLI::App& app, Sharding& sharding) {
  CLI::Option* const shard = app.add_option("--shard", sharding.shard,
                                            "simulate part K of N only, into a file of its own in "
                                            "the folder of --output");
  shard->type_name("K/N");
  CLI::Option* const collect = app.add_flag("--collect", sharding.collect,
                                            "join the shards in the folder, if they are complete");
  CLI::Option* const status =
      app.add_flag("--status", sharding.status, "say how far the shards in the folder are");
  shard->excludes(collect)->excludes(status);
  collect->excludes(status);
  offer_formats(app, sharding.format);
  for (const char* const format : {"--text", "--yaml", "--json"}) {
    app.get_option(format)->needs(status);
  }
}

inline YAML::Node to_yaml(const ShardedSeries& series, const SeriesProgress& progress) {
  YAML::Node tree;
  tree["folder"] = series.folder().string();
  tree["runs"] = progress.runs;
  tree["done"] = progress.done;
  tree["failed"] = progress.failed;
  tree["seconds_left"] = progress.seconds_left;
  tree["shards"] = progress.count;
  tree["unfinished"] = YAML::Node(YAML::NodeType::Sequence);
  for (const ShardProgress& one : progress.unfinished) {
    YAML::Node shard;
    shard["shard"] = one.shard.number;
    shard["runs"] = one.runs;
    shard["done"] = one.done;
    shard["failed"] = one.failed;
    shard["seconds_left"] = one.seconds_left;
    tree["unfinished"].push_back(shard);
  }
  return tree;
}

inline std::string text(const SeriesProgress& progress) {
  std::string all = fmt::format("{} of {} runs done, {} failed, {} left\n", progress.done,
                                progress.runs, progress.failed, progress.runs - progress.done);
  if (progress.done == progress.runs) return all;
  all += fmt::format("about {} of one processor", text_of_time(progress.seconds_left));
  if (progress.count == 0) return all + "; no shard has been begun\n";
  double longest = 0.0;
  TextTable table{{"shard", "runs", "done", "failed", "time left"}};
  for (const ShardProgress& one : progress.unfinished) {
    longest = std::max(longest, one.seconds_left);
    table.push_back({text(one.shard), std::to_string(one.runs), std::to_string(one.done),
                     std::to_string(one.failed), text_of_time(one.seconds_left)});
  }
  return fmt::format("{}, {} if all shards run at once\n\n{}", all, text_of_time(longest),
                     aligned(table));
}

/// Threads, and what is told and asked while the runs go on.
inline SeriesOptions watched(int jobs, ProgressBar& bar) {
  return {jobs, [&bar](std::size_t /*rows*/, std::size_t runs) { bar.show(runs); }, interrupted};
}

/// Simulates one shard, with a progress bar.
inline std::vector<Row> simulate_shard(const std::string& program, const ShardedSeries& series,
                                       const Shard& shard, int jobs) {
  take_interruptions();
  std::vector<Row> rows;
  {
    ProgressBar bar(fmt::format("{}: shard {}", program, text(shard)), series.runs_of(shard));
    rows = series.run(shard, watched(jobs, bar));
  }
  fmt::print("shard {}: {} runs done\n", text(shard), rows.size());
  return rows;
}

/// Prints how far the series is.
inline void print_status(const ShardedSeries& series, Format format) {
  const SeriesProgress progress = series.progress();
  if (is_text(format)) {
    fmt::print("{}", text(progress));
  } else {
    print_document(to_yaml(series, progress), format);
  }
}

}  // namespace impact
