#pragma once

#include <ros/ros.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "measure/impact_analysis.hpp"
#include "nodes/data_streams.hpp"
#include "nodes/node_parameters.hpp"
#include "nodes/progress_log.hpp"
#include "nodes/readers.hpp"
#include "run/error_control.hpp"
#include "run/run.hpp"
#include "scene/scene.hpp"

namespace impact {

/// One a scene of a series; null: to be made anew.
using Compositions = std::vector<std::shared_ptr<const Composition>>;

/// Composes every run of the series, so that bad input is found before anything runs, and
/// forecasts the size of its messages. The compositions are kept as long as their points are no
/// more than 10⁶ in all, the first in any case.
/// @throw InputError as compose(), for a scene that has no motion to publish, and when the bag
/// would not fit on its disk.
Compositions check_series(const SimulationNodeParameters& parameters,
                          const std::vector<Scene>& series);

/// Simulates a series of runs, one after another, and publishes them.
class SimulationNode {
 public:
  /// `compositions`: see check_series().
  SimulationNode(const SimulationNodeParameters& parameters, std::vector<Scene> series,
                 Compositions compositions);

  /// Runs the series. False when it was interrupted.
  /// @throw InputError when the bag cannot be opened; std::runtime_error when a reader is missing,
  /// and when a run cannot go on, after that has been published and the bag closed.
  bool run_series();

 private:
  void simulate(const Scene& scene, const std::shared_ptr<const Composition>& composition);
  Restitution publish_run(Run& run, const Scene& scene);
  void start(const Scene& scene, const Run& run);
  void publish_output(Run& run, ImpactAnalysis& analysis);
  void send_lattice(std::size_t body, const Run& run);
  void send(std::size_t body, const Run& run, const ContactReport& report);
  void send_scalars(const Run& run, const ContactReport& report);
  void publish_status(const Run& run, std::uint8_t phase, const std::string& error = {});
  void take_answer(const ErrorControl& control);
  void keep_pace();
  void wait_for_readers(std::int64_t sequence);
  bool all_listeners_acknowledge() const;
  void close_bag(bool complete);
  ros::Time stamp(const Run& run) const;

  SimulationNodeParameters parameters_;
  std::vector<Scene> series_;
  Compositions compositions_;
  ros::NodeHandle node_;
  Readers readers_;
  Readers wall_readers_;
  Readers scalar_readers_;
  DataStreams streams_;
  Pacing pacing_;
  ros::Publisher clock_;
  std::optional<ros::WallRate> rate_;

  ros::Time run_start_{1.0};              ///< simulated; a bag refuses the stamp 0
  lattice_impact::RunStatus status_;      ///< of the present run, as last published
  lattice_impact::ContactForces forces_;  ///< as last published, of any body
  std::optional<ProgressLog> progress_;   ///< of the present run
  std::uint64_t checksum_ = 0;            ///< of the disk's messages of the present run
};

}  // namespace impact
