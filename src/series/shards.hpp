#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "series/series.hpp"

namespace impact {

/// One of the parts into which a series is divided.
struct Shard {
  std::size_t number;  ///< from 1
  std::size_t count;   ///< of all shards
};

/// "3/16".
std::string text(const Shard& shard);

/// @throw InputError unless the text is K/N, and 1 ≤ K ≤ N ≤ kMostScenes.
Shard parse_shard(const std::string& text);

/// The rows of the series that each of so many shards has, rising: of equal time, as far as
/// forecast() knows it. The scenes of one lattice stay together, which keeps the lanes full; where
/// they take longer than a shard should, they are cut into pieces, of kLanes scenes at least.
/// A shard may have none.
std::vector<std::vector<std::size_t>> divide(const std::vector<Scene>& series, std::size_t count);

/// How far a shard is.
struct ShardProgress {
  Shard shard{};
  std::size_t runs = 0;  ///< not 0
  std::size_t done = 0;
  std::size_t failed = 0;     ///< of those done
  double seconds_left = 0.0;  ///< of one processor
};

/// How far a series is.
struct SeriesProgress {
  std::size_t runs = 0;
  std::size_t done = 0;
  std::size_t failed = 0;     ///< of those done
  double seconds_left = 0.0;  ///< of one processor
  std::size_t count = 0;      ///< of the shards; 0: none has been begun
  std::vector<ShardProgress> unfinished{};
};

/// A series whose shards are simulated by processes that know nothing of each other, each into the
/// file shard-K-of-N.csv of its own in a common folder, a SeriesFile of a part.
class ShardedSeries {
 public:
  ShardedSeries(std::vector<Scene> series, std::filesystem::path folder);

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path file_of(const Shard& shard) const;
  std::size_t runs_of(const Shard& shard) const;

  /// As run_series(); makes the folder.
  /// @return the rows of the shard.
  /// @throw InputError as run_series(), and when the folder has shards of another number.
  std::vector<Row> run(const Shard& shard, const SeriesOptions& options) const;

  /// By the forecast() of the runs left, corrected by how long those done took.
  /// @throw InputError for files of another series, version or number of shards than others.
  SeriesProgress progress() const;

  /// Writes all rows into the file of the series, which may have its first rows already.
  /// @return all rows.
  /// @throw InputError as progress() and SeriesFile.
  /// @throw std::runtime_error when rows are missing; then nothing is written.
  std::vector<Row> collect(const std::filesystem::path& file) const;

 private:
  std::size_t count_of_shards() const;
  SeriesPart part(const std::vector<std::size_t>& rows) const;
  std::vector<std::string> lines() const;

  std::vector<Scene> series_;
  std::filesystem::path folder_;
};

}  // namespace impact
