#include "nodes/data_streams.hpp"

#include <fmt/format.h>

#include "lattice/input_error.hpp"

namespace impact {

DataStreams::Topics::Topics(Readers& readers, const std::string& prefix)
    : lattice(readers.advertise<lattice_impact::Lattice>(prefix + "lattice", true)),
      states(readers.advertise<lattice_impact::ParticleStates>(prefix + "particle_states")),
      forces(readers.advertise<lattice_impact::ContactForces>(prefix + "contact_forces")) {}

DataStreams::DataStreams(Readers& readers, Readers* wall_readers)
    : disk_(readers, ""),
      status_(readers.advertise<lattice_impact::RunStatus>("run_status", true)) {
  if (wall_readers != nullptr) wall_.emplace(*wall_readers, "wall/");
}

bool DataStreams::heard(Body body) const {
  return bag_ || topics(body).states.getNumSubscribers() > 0 ||
         topics(body).forces.getNumSubscribers() > 0;
}

void DataStreams::open_bag(const std::string& bag) {
  if (bag.empty()) return;
  try {
    bag_.emplace(bag, rosbag::bagmode::Write);
  } catch (const rosbag::BagException& error) {
    throw InputError(fmt::format("bag: {} cannot be written: {}", bag, error.what()));
  }
}

template <class Message>
void DataStreams::send(const ros::Publisher& publisher, const Message& message) {
  if (bag_) bag_->write(publisher.getTopic(), message.header.stamp, message);
  if (publisher.getNumSubscribers() > 0 || publisher.isLatched()) publisher.publish(message);
}

void DataStreams::send(Body body, const lattice_impact::Lattice& message) {
  send(topics(body).lattice, message);
}

void DataStreams::send(Body body, const lattice_impact::ParticleStates& message) {
  send(topics(body).states, message);
}

void DataStreams::send(Body body, const lattice_impact::ContactForces& message) {
  send(topics(body).forces, message);
}

void DataStreams::send(const lattice_impact::RunStatus& message) { send(status_, message); }

void DataStreams::close() {
  if (bag_) bag_->close();
}

}  // namespace impact
