#pragma once

#include <lattice_impact/Acknowledged.h>
#include <ros/ros.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "nodes/bag_file.hpp"
#include "nodes/inventory.hpp"
#include "nodes/message_source.hpp"
#include "nodes/node_parameters.hpp"

namespace impact {

/// Records a series and its results into a bag. It paces the simulation by its acknowledgements, so
/// that nothing piles up, and ends when everything that was published is in the file.
class RecorderNode {
 public:
  /// @throw InputError when the bag cannot be written.
  explicit RecorderNode(const RecorderNodeParameters& parameters);

  /// Records until the series is over, or its publishers have gone, or, when interrupted, until
  /// nothing more comes.
  /// @throw std::runtime_error when the recording is not complete, with what it lacks in the log,
  /// when the disk does not take it, or nothing came at all.
  void run();

 private:
  template <class Message>
  void record(const std::string& topic);
  void take_acknowledgement(const lattice_impact::Acknowledged& message);
  void acknowledge_states(std::uint32_t run);
  void acknowledge(std::uint32_t run, std::uint32_t sequence);
  void acknowledge_finished_runs();
  bool has_results_of(std::uint32_t run) const;
  bool is_done() const;
  bool nothing_more_comes() const;
  bool simulation_is_there() const;
  void finish();

  RecorderNodeParameters parameters_;
  ros::NodeHandle node_;
  BagFile bag_;
  Inventory inventory_;
  std::map<std::string, std::uint64_t> results_;  ///< recorded, by topic
  /// The latest of each node that publishes results.
  std::map<std::string, lattice_impact::Acknowledged> results_announced_;
  std::uint64_t state_messages_ = 0;                  ///< recorded, of states and forces
  std::pair<std::uint32_t, std::uint32_t> recorded_;  ///< the latest run, and states of it
  std::uint32_t first_open_run_ = 0;
  ros::Publisher acknowledged_;
  std::vector<ros::Subscriber> subscribers_;
  MessageSource simulation_;
};

}  // namespace impact
