#pragma once

#include <lattice_impact/ContactForces.h>
#include <lattice_impact/Lattice.h>
#include <lattice_impact/ParticleStates.h>
#include <lattice_impact/RunStatus.h>
#include <lattice_impact/Scalars.h>
#include <ros/ros.h>

#include <optional>
#include <string>

#include "nodes/bag_file.hpp"
#include "nodes/readers.hpp"

namespace impact {

/// A part of the scene that has topics of its own.
enum class BodyTopic { kDisk, kWall };

/// The topics that carry a run, to subscribers and, if asked for, into a bag: `run_status`; for the
/// disk `lattice`, `particle_states` and `contact_forces`; the same below `wall/` for an elastic
/// wall; `scalars`.
class DataStreams {
 public:
  /// `wall_readers`: nullptr when no run has an elastic wall; then it has no topics.
  DataStreams(Readers& readers, Readers* wall_readers, Readers& scalar_readers);

  /// From here on everything goes into this file too; empty: none.
  /// @throw InputError when it cannot be opened.
  void open_bag(const std::string& bag);

  /// Somebody takes the body's states and forces: a bag or a subscriber.
  bool heard(BodyTopic body) const;
  /// The same of the scalars.
  bool scalars_heard() const;

  void send(BodyTopic body, const lattice_impact::Lattice& message);
  void send(BodyTopic body, const lattice_impact::ParticleStates& message);
  void send(BodyTopic body, const lattice_impact::ContactForces& message);
  void send(const lattice_impact::RunStatus& message);
  void send(const lattice_impact::Scalars& message);

  /// Finishes the bag: BagFile::finish(). Returns its name; empty: there is none.
  std::string close(bool complete);

 private:
  struct Topics {
    Topics(Readers& readers, const std::string& prefix);
    ros::Publisher lattice;
    ros::Publisher states;
    ros::Publisher forces;
  };

  template <class Message>
  void write(const std::string& topic, const Message& message);
  const Topics& topics(BodyTopic body) const { return body == BodyTopic::kDisk ? disk_ : *wall_; }
  template <class Message>
  void send(const ros::Publisher& publisher, const Message& message);

  Topics disk_;
  std::optional<Topics> wall_;
  ros::Publisher status_;
  ros::Publisher scalars_;
  std::optional<BagFile> bag_;
};

}  // namespace impact
