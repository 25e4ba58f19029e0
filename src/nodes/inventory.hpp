#pragma once

#include <lattice_impact/RunStatus.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace impact {

/// The last word of a run was said.
bool has_ended(const std::optional<lattice_impact::RunStatus>& status);

/// The messages of a series that have come, run by run, against those that the simulation says it
/// published. Topics go by their names below the simulation's namespace. The scalars of a run may
/// be missing, since they are published only while somebody listens; once one has come, each must.
class Inventory {
 public:
  /// A message of a topic other than run_status.
  void add(const std::string& topic, std::uint32_t run);
  void add(const lattice_impact::RunStatus& status);

  /// Messages of a topic of the simulation that it published in all runs that are there: what it
  /// said at their ends, and of a run without an end no less than have come.
  std::uint64_t published(const std::string& topic) const;

  /// States of the run with this number of which everything but the scalars has come: those
  /// 0 … n − 1.
  std::uint32_t states(std::uint32_t number) const;

  /// The end of the run with this number was announced, and everything of it has come.
  bool has_all_of(std::uint32_t number) const;

  /// Number of the last run that will come: that of the series, or the first that has ended without
  /// being finished. Before anything is known of it, the largest number.
  std::uint32_t last_run() const;

  /// What is missing, and runs that were not finished, a line each.
  std::vector<std::string> problems() const;

 private:
  struct Run {
    std::map<std::string, std::uint32_t> counts;      ///< by topic
    std::optional<lattice_impact::RunStatus> status;  ///< the latest
  };

  /// Those of the simulation in a run with this status.
  static std::vector<std::string> topics(const lattice_impact::RunStatus& status);
  static std::uint32_t promised(const Run& run, const std::string& topic);
  static std::uint32_t count(const Run& run, const std::string& topic);
  static bool has_all(const Run& run);
  static void add_problems(std::uint32_t number, const Run& run, std::vector<std::string>& lines);

  std::map<std::uint32_t, Run> runs_;
};

}  // namespace impact
