#include "series/shards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <queue>
#include <regex>
#include <set>
#include <stdexcept>
#include <utility>

#include "kernels/kernels.hpp"
#include "run/bodies.hpp"
#include "run/compose.hpp"
#include "run/forecast.hpp"
#include "scene/keys.hpp"
#include "scene/scene_parameters.hpp"
#include "series/side_by_side.hpp"

namespace impact {
namespace {

using Rows = std::vector<std::size_t>;

/// Rows that stay together, and what they cost.
struct Piece {
  Rows rows;
  std::int64_t cost;
};

/// In µs and never 0. Whole numbers, so that processors whose last bits differ divide alike.
std::int64_t cost_of_run(const Scene& scene) {
  constexpr double kMicroseconds = 1e6;
  return 1 + std::llround(kMicroseconds * forecast(scene).seconds);
}

std::vector<std::int64_t> costs_of(const std::vector<Scene>& series) {
  std::vector<std::int64_t> costs;
  costs.reserve(series.size());
  for (const Scene& scene : series) costs.push_back(cost_of_run(scene));
  return costs;
}

/// The rows of each lattice, in the order of the first ones.
std::vector<Rows> lattices_of(const std::vector<Scene>& series) {
  std::map<std::string, std::size_t> places;
  std::vector<Rows> lattices;
  for (std::size_t row = 0; row < series.size(); ++row) {
    const auto place = places.try_emplace(key_of_bodies(series[row]), lattices.size()).first;
    if (place->second == lattices.size()) lattices.emplace_back();
    lattices[place->second].push_back(row);
  }
  return lattices;
}

/// The rows in pieces that are not cheaper than `most`, and not fewer than `fewest` rows; the last
/// one takes what is left.
std::vector<Piece> cut(const Rows& rows, const std::vector<std::int64_t>& costs, std::int64_t most,
                       std::size_t fewest) {
  std::vector<Piece> pieces{{{}, 0}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool is_full = pieces.back().cost >= most && pieces.back().rows.size() >= fewest;
    if (is_full && rows.size() - i >= fewest) pieces.push_back({{}, 0});
    pieces.back().rows.push_back(rows[i]);
    pieces.back().cost += costs[rows[i]];
  }
  return pieces;
}

std::vector<Piece> pieces_of(const std::vector<Scene>& series, std::int64_t shards) {
  const std::vector<std::int64_t> costs = costs_of(series);
  const std::int64_t share =
      1 + std::accumulate(costs.begin(), costs.end(), std::int64_t{0}) / shards;
  std::vector<Piece> all;
  for (const Rows& rows : lattices_of(series)) {
    const std::int64_t cost =
        std::accumulate(rows.begin(), rows.end(), std::int64_t{0},
                        [&](std::int64_t sum, std::size_t row) { return sum + costs[row]; });
    const bool in_lanes = may_be_in_lanes(series[rows.front()]);
    const std::vector<Piece> pieces =
        cut(rows, costs, cost > share ? share / 2 : cost, in_lanes ? kLanes : 1);
    all.insert(all.end(), pieces.begin(), pieces.end());
  }
  return all;
}

/// "a, b, c and 7 more".
std::string listed(const std::vector<std::string>& texts) {
  constexpr std::size_t kMost = 5;
  const std::size_t shown = std::min(kMost, texts.size());
  const std::string list =
      fmt::format("{}", fmt::join(texts.begin(), texts.begin() + static_cast<int>(shown), ", "));
  return shown == texts.size() ? list : fmt::format("{} and {} more", list, texts.size() - shown);
}

/// The first file of each number of shards that the folder has.
std::map<std::size_t, std::string> shards_by_count(const std::filesystem::path& folder) {
  static const std::regex pattern("shard-[1-9][0-9]{0,5}-of-([1-9][0-9]{0,5})\\.csv");
  std::map<std::size_t, std::string> found;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    std::smatch match;
    const std::string name = entry.path().filename().string();
    if (!std::regex_match(name, match, pattern)) continue;
    std::string& first = found[std::stoul(match[1])];
    if (first.empty() || name < first) first = name;
  }
  return found;
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(fmt::format("{}: {}", folder.string(), error.message()));
}

/// What runs took, against what forecast() says of them (s).
class Times {
 public:
  /// @return what forecast() says of the runs that are left.
  double add(const SeriesFile& file) {
    double left = 0.0;
    for (std::size_t i = 0; i < file.scenes().size(); ++i) {
      const double seconds = forecast(file.scenes()[i]).seconds;
      if (i < file.rows().size()) {
        note(file.rows()[i].results.at("wall_time"), seconds);
      } else {
        left += seconds;
      }
    }
    return left;
  }

  double correction() const { return expected_ > 0.0 ? taken_ / expected_ : 1.0; }

 private:
  void note(double time, double seconds) {
    if (!std::isfinite(time)) return;
    taken_ += time;
    expected_ += seconds;
  }

  double taken_ = 0.0;
  double expected_ = 0.0;
};

ShardProgress progress_of(const Shard& shard, const SeriesFile& file) {
  const auto failed = std::count_if(file.rows().begin(), file.rows().end(), has_failed);
  return {shard, file.scenes().size(), file.rows().size(), static_cast<std::size_t>(failed)};
}

}  // namespace

std::string text(const Shard& shard) { return fmt::format("{}/{}", shard.number, shard.count); }

Shard parse_shard(const std::string& text) {
  std::smatch match;
  if (std::regex_match(text, match, std::regex("([1-9][0-9]{0,5})/([1-9][0-9]{0,5})"))) {
    const Shard shard{std::stoul(match[1]), std::stoul(match[2])};
    if (shard.number <= shard.count && shard.count <= kMostScenes) return shard;
  }
  throw bad_value("--shard", text, fmt::format("K/N with 1 <= K <= N <= {}", kMostScenes));
}

/// The most expensive piece first, each to the shard that has least so far: no shard gets more than
/// the mean and one piece.
std::vector<Rows> divide(const std::vector<Scene>& series, std::size_t count) {
  std::vector<Piece> pieces = pieces_of(series, static_cast<std::int64_t>(count));
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.cost > b.cost; });
  using Load = std::pair<std::int64_t, std::size_t>;
  std::priority_queue<Load, std::vector<Load>, std::greater<>> loads;
  for (std::size_t shard = 0; shard < count; ++shard) loads.emplace(0, shard);
  std::vector<Rows> shards(count);
  for (const Piece& piece : pieces) {
    const auto [load, shard] = loads.top();
    loads.pop();
    loads.emplace(load + piece.cost, shard);
    shards[shard].insert(shards[shard].end(), piece.rows.begin(), piece.rows.end());
  }
  for (Rows& rows : shards) std::sort(rows.begin(), rows.end());
  return shards;
}

ShardedSeries::ShardedSeries(std::vector<Scene> series, std::filesystem::path folder)
    : series_(std::move(series)), folder_(std::move(folder)) {}

std::filesystem::path ShardedSeries::file_of(const Shard& shard) const {
  return folder_ / fmt::format("shard-{}-of-{}.csv", shard.number, shard.count);
}

std::size_t ShardedSeries::runs_of(const Shard& shard) const {
  return divide(series_, shard.count)[shard.number - 1].size();
}

SeriesPart ShardedSeries::part(const Rows& rows) const {
  SeriesPart part;
  for (const std::size_t row : rows) {
    part.scenes.push_back(series_[row]);
    part.numbers.push_back(row + 1);
  }
  return part;
}

/// 0: there are none.
std::size_t ShardedSeries::count_of_shards() const {
  const auto found = shards_by_count(folder_);
  if (found.size() < 2) return found.empty() ? 0 : found.begin()->first;
  std::vector<std::string> names;
  names.reserve(found.size());
  for (const auto& [count, name] : found) names.push_back(name);
  throw InputError(
      fmt::format("{}: has runs doubled, in {}: remove the shards of all numbers N but one",
                  folder_.string(), listed(names)));
}

std::vector<Row> ShardedSeries::run(const Shard& shard, const SeriesOptions& options) const {
  for (const Scene& scene : series_) refuse_impossible(scene);
  make_folder(folder_);
  const std::size_t count = count_of_shards();
  if (count != 0 && count != shard.count) {
    throw InputError(
        fmt::format("--shard: got {}, {} has shards of {}", text(shard), folder_.string(), count));
  }
  const Rows rows = divide(series_, shard.count)[shard.number - 1];
  if (rows.empty()) return {};
  return run_series(SeriesFile(file_of(shard), SeriesColumns(series_), part(rows)), options);
}

SeriesProgress ShardedSeries::progress() const {
  SeriesProgress all;
  all.runs = series_.size();
  all.count = count_of_shards();
  const SeriesColumns columns(series_);
  Times times;
  const std::vector<Rows> rows = divide(series_, std::max<std::size_t>(1, all.count));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Shard shard{i + 1, rows.size()};
    const SeriesFile file = SeriesFile::so_far(file_of(shard), columns, part(rows[i]));
    ShardProgress one = progress_of(shard, file);
    one.seconds_left = times.add(file);
    all.done += one.done;
    all.failed += one.failed;
    if (one.done < one.runs) all.unfinished.push_back(one);
  }
  for (ShardProgress& one : all.unfinished) {
    one.seconds_left *= times.correction();
    all.seconds_left += one.seconds_left;
  }
  if (all.count == 0) all.unfinished.clear();
  return all;
}

std::vector<std::string> ShardedSeries::lines() const {
  const std::size_t count = count_of_shards();
  if (count == 0) throw std::runtime_error(folder_.string() + ": has no shards");
  const SeriesColumns columns(series_);
  const std::vector<Rows> rows = divide(series_, count);
  std::vector<std::string> lines(series_.size());
  std::vector<std::string> unfinished;
  std::size_t done = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Shard shard{i + 1, count};
    const SeriesFile file = SeriesFile::so_far(file_of(shard), columns, part(rows[i]));
    const std::size_t runs = file.lines().size();
    for (std::size_t k = 0; k < runs; ++k) lines[rows[i][k]] = file.lines()[k];
    done += runs;
    if (runs == rows[i].size()) continue;
    unfinished.push_back(fmt::format("{} has {} of {}", text(shard), runs, rows[i].size()));
  }
  if (unfinished.empty()) return lines;
  throw std::runtime_error(fmt::format("{}: {} of {} runs are missing: shard {}", folder_.string(),
                                       lines.size() - done, lines.size(), listed(unfinished)));
}

std::vector<Row> ShardedSeries::collect(const std::filesystem::path& file) const {
  const std::vector<std::string> all = lines();
  SeriesFile whole(file, series_);
  whole.open();
  for (std::size_t row = whole.rows().size(); row < all.size(); ++row) whole.append_line(all[row]);
  return whole.rows();
}

}  // namespace impact
