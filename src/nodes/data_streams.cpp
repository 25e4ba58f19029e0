#include "nodes/data_streams.hpp"

#include <fmt/format.h>

#include "lattice/input_error.hpp"

namespace impact {

DataStreams::DataStreams(Readers& readers)
    : lattice_(readers.advertise<lattice_impact::Lattice>("lattice", true)),
      states_(readers.advertise<lattice_impact::ParticleStates>("particle_states")),
      forces_(readers.advertise<lattice_impact::ContactForces>("contact_forces")),
      status_(readers.advertise<lattice_impact::RunStatus>("run_status", true)) {}

bool DataStreams::heard() const {
  return bag_ || states_.getNumSubscribers() > 0 || forces_.getNumSubscribers() > 0;
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
void DataStreams::send(ros::Publisher& publisher, const Message& message) {
  if (bag_) bag_->write(publisher.getTopic(), message.header.stamp, message);
  if (publisher.getNumSubscribers() > 0 || publisher.isLatched()) publisher.publish(message);
}

void DataStreams::send(const lattice_impact::Lattice& message) { send(lattice_, message); }
void DataStreams::send(const lattice_impact::ParticleStates& message) { send(states_, message); }
void DataStreams::send(const lattice_impact::ContactForces& message) { send(forces_, message); }
void DataStreams::send(const lattice_impact::RunStatus& message) { send(status_, message); }

void DataStreams::close() {
  if (bag_) bag_->close();
}

}  // namespace impact
