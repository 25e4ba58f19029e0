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
  /// `bag`: file to write; empty: none.
  /// @throw InputError when the file cannot be opened.
  DataStreams(Readers& readers, const std::string& bag);

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
