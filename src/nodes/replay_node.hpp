#pragma once

#include <ros/ros.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "nodes/node_parameters.hpp"
#include "nodes/readers.hpp"

namespace impact {

/// Publishes once more what a simulation has published, as a bag has it: at the times of the
/// recording, and in the topics of the node's own namespace. Nothing is lost, whatever the rate:
/// as the simulation did, it waits for its readers before it begins, is paced by their
/// acknowledgements, and goes when they have taken in the last message.
class ReplayNode {
 public:
  /// @throw InputError when the bag cannot be read or holds no such simulation.
  explicit ReplayNode(const ReplayNodeParameters& parameters);

  /// Until everything has been taken in, the readers have gone, or it is asked to end.
  /// @throw std::runtime_error when a reader does not come.
  void run();

 private:
  /// A state of a run; or, as the number of its states, the end of it.
  using Position = std::pair<std::uint32_t, std::int64_t>;

  std::string topic_of(const std::string& recorded) const;
  void advertise(const rosbag::ConnectionInfo& connection);
  void wait_until(const ros::Time& recorded) const;
  void publish(const rosbag::MessageInstance& message);
  void keep_pace();
  bool wait_for(const Position& position, double patience);
  bool readers_are_there() const;

  ReplayNodeParameters parameters_;
  std::string prefix_;  ///< of the topics in the bag, without the slash behind it
  ros::NodeHandle node_;
  rosbag::Bag bag_;
  rosbag::View view_;
  ros::Time begin_;      ///< of the recording
  ros::WallTime start_;  ///< of the replay
  Readers readers_;
  Readers others_;  ///< of topics that only some listen to
  Pacing pacing_;
  std::map<std::string, ros::Publisher> publishers_;  ///< by the topic in the bag
  Position latest_{0, -1};                            ///< of what was published
  std::optional<std::uint32_t> unpaced_run_;          ///< damaged: it is not acknowledged
};

/// Only to see whether it can be replayed.
/// @throw InputError as the constructor of ReplayNode.
void check_bag(const ReplayNodeParameters& parameters);

}  // namespace impact
