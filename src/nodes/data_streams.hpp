#pragma once

#include <lattice_impact/Lattice.h>
#include <lattice_impact/RunStatus.h>
#include <lattice_impact/Scalars.h>
#include <ros/ros.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "nodes/bag_file.hpp"
#include "nodes/raw_message.hpp"
#include "nodes/readers.hpp"

namespace impact {

/// The topics that carry a run, to subscribers and, if asked for, into a bag: `run_status`; for the
/// disk `lattice`, `particle_states` and `contact_forces`; the same below topics_of_body() for what
/// it meets, as far as that is made of points; `scalars`.
class DataStreams {
 public:
  /// `bodies`: the most that a run has. `wall_readers`: of all but the disk.
  DataStreams(std::size_t bodies, Readers& readers, Readers& wall_readers, Readers& scalar_readers);

  /// From here on everything goes into this file too; empty: none.
  /// @throw InputError when it cannot be opened.
  void open_bag(const std::string& bag);

  /// Somebody takes the states and forces of the body of this number: a bag or a subscriber.
  bool heard(std::size_t body) const;
  /// The same of the scalars.
  bool scalars_heard() const;

  void send(std::size_t body, const lattice_impact::Lattice& message);
  void send(std::size_t body, const ros::Time& stamp,
            const RawMessage<lattice_impact::ParticleStates>& message);
  void send(std::size_t body, const ros::Time& stamp,
            const RawMessage<lattice_impact::ContactForces>& message);
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
  void write(const std::string& topic, const ros::Time& stamp, const Message& message);
  template <class Message>
  void send(const ros::Publisher& publisher, const ros::Time& stamp, const Message& message);

  std::vector<Topics> bodies_;
  ros::Publisher status_;
  ros::Publisher scalars_;
  std::optional<BagFile> bag_;
};

}  // namespace impact
