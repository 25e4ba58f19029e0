#pragma once

#include <lattice_impact/RunStatus.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "measure/impact_analysis.hpp"
#include "measure/strain.hpp"
#include "nodes/conversions.hpp"
#include "nodes/run_checks.hpp"
#include "scene/scene.hpp"

namespace impact {

/// What a run of a series came to.
struct ClosedRun {
  std_msgs::Header header;   ///< of its last state
  std::uint32_t number = 0;  ///< of the series, from 0
  Scene scene;
  std::vector<std::string> flags;
  /// ξ (R) of a contact, e of a collision; NaN when there is none.
  double answer = std::numeric_limits<double>::quiet_NaN();
};

/// Turns the messages of a series of runs into its results. Messages of one topic must come in the
/// order in which they were published; between topics any order will do, so that a live
/// connection, a replay and a bag that is read directly give the same bits. It knows of the
/// physics only what the messages say, and believes none unseen (RunChecks): a run with a message
/// that cannot be has no numbers and the flag `damaged`, and the other runs keep theirs.
class SeriesAnalysis {
 public:
  /// Where the results go.
  struct Outputs {
    std::function<void(const lattice_impact::Strain&)> strain;
    std::function<void(const lattice_impact::Restitution&)> restitution;
    /// The run has ended, and its other results are out.
    std::function<void(const ClosedRun&)> closed;
    /// All messages of the run up to this sequence number have been taken in. When the run is
    /// closed and its results are out, the number is that of its states: one past the last.
    std::function<void(std::uint32_t run, std::uint32_t sequence)> taken_in;
    /// Something is wrong with the data, in one line.
    std::function<void(const std::string&)> problem;
  };

  explicit SeriesAnalysis(Outputs outputs) : outputs_(std::move(outputs)) {}

  void add(const lattice_impact::Lattice& message);
  void add(const lattice_impact::ParticleStates& message);
  void add(const lattice_impact::ContactForces& message);
  void add(const lattice_impact::RunStatus& message);

  /// No more messages will come: closes every run that is open, as incomplete.
  void close();

  /// The messages that are missing will not come: closes those runs that have announced their end.
  /// Others go on.
  void close_ended();

  /// True while a run has announced its end but messages of it are missing.
  bool waits_for_missing() const;

  /// True when something of the run with this number has come, and its results are not yet out.
  bool is_open(std::uint32_t number) const { return runs_.count(number) > 0; }

  /// True when the last run of the series is closed and no other is open.
  bool done() const { return series_ended_ && runs_.empty(); }

 private:
  struct Run {
    std::optional<StrainMeter> strain_meter;
    std::deque<lattice_impact::ParticleStates> states;  ///< not yet taken in
    std::deque<lattice_impact::ContactForces> forces;   ///< not yet taken in
    std::uint32_t next_sequence = 0;
    std::uint32_t strains_published = 0;
    bool gap = false;
    bool damaged = false;  ///< nothing of it is believed
    RunChecks checks;
    std::uint64_t checksum = 0;  ///< of what was taken in
    ImpactAnalysis impact;
    lattice_impact::Strain last_strain;
    std::optional<lattice_impact::RunStatus> status;  ///< the latest
    std::optional<Scene> scene;                       ///< from the status
    bool announced = false;                           ///< Restitution of the start was published
  };

  void advance(std::uint32_t number);
  void take_in(Run& run, const lattice_impact::ParticleStates& states,
               const lattice_impact::ContactForces& forces);
  void damage(Run& run, std::uint32_t number, const std::string& what) const;
  void report_gap(Run& run, std::uint32_t number, std::uint32_t found) const;
  void close(std::uint32_t number);
  void give_up(std::uint32_t number);
  void publish_strain(Run& run, lattice_impact::Strain strain) const;
  void publish_restitution(const Run& run, bool ended, bool complete) const;
  static lattice_impact::Restitution answer_of(const Run& run, bool complete);
  void report_closed(const Run& run, std::uint32_t number, bool complete) const;
  Run& open_run(std::uint32_t number) { return runs_[number]; }

  Outputs outputs_;
  std::map<std::uint32_t, Run> runs_;  ///< those open, by number
  bool series_ended_ = false;
};

}  // namespace impact
