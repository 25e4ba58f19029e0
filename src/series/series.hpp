#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <vector>

#include "series/series_file.hpp"

namespace impact {

struct SeriesOptions {
  int jobs = 1;  ///< threads
  /// Told at the start, after every row and at least five times a second how many rows there are,
  /// and how many runs are done.
  std::function<void(std::size_t rows, std::size_t runs)> progress{};
  /// True, for good, once the series is to be broken off. Asked often, and from all threads.
  std::function<bool()> stop{};
};

/// Simulates the scenes and writes each into its row of the file as soon as it and all before it
/// are done: except for wall_time, the file does not depend on the number of threads. Rows that the
/// file has already are not simulated again. Consecutive static contacts that differ only in the
/// load are found each from the one before, unless that has flags. A run that cannot go on has its
/// reason in its flags.
/// @return all rows, also those that were there.
/// @throw InputError as SeriesFile and compose(); before anything has run, unless only a later
/// scene cannot be composed.
/// @throw std::runtime_error when broken off or when the file cannot be written.
std::vector<Row> run_series(const std::vector<Scene>& scenes, const std::filesystem::path& file,
                            const SeriesOptions& options);

/// The same with the scenes of the file.
/// @throw as the other one, but for what SeriesFile and refuse_impossible() throw.
std::vector<Row> run_series(SeriesFile file, const SeriesOptions& options);

}  // namespace impact
