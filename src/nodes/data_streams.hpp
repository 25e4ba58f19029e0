#pragma once

#include <lattice_impact/ContactForces.h>
#include <lattice_impact/Lattice.h>
#include <lattice_impact/ParticleStates.h>
#include <lattice_impact/RunStatus.h>
#include <ros/ros.h>
#include <rosbag/bag.h>

#include <optional>
#include <string>

#include "nodes/readers.hpp"

namespace impact {

/// The four topics that carry a run, to subscribers and, if asked for, into a bag.
class DataStreams {
 public:
  explicit DataStreams(Readers& readers);

  /// From here on everything goes into this file too; empty: none.
  /// @throw InputError when it cannot be opened.
  void open_bag(const std::string& bag);

  /// Somebody takes states and forces: a bag or a subscriber.
  bool heard() const;

  void send(const lattice_impact::Lattice& message);
  void send(const lattice_impact::ParticleStates& message);
  void send(const lattice_impact::ContactForces& message);
  void send(const lattice_impact::RunStatus& message);

  /// Finishes the bag, so that it can be read.
  void close();

 private:
  template <class Message>
  void send(ros::Publisher& publisher, const Message& message);

  ros::Publisher lattice_;
  ros::Publisher states_;
  ros::Publisher forces_;
  ros::Publisher status_;
  std::optional<rosbag::Bag> bag_;
};

}  // namespace impact
