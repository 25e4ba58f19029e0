#include "nodes/data_streams.hpp"

#include <stdexcept>
#include <utility>

#include "nodes/body_topics.hpp"

namespace impact {

DataStreams::Topics::Topics(Readers& readers, const std::string& prefix)
    : lattice(readers.advertise<lattice_impact::Lattice>(prefix + "lattice", true)),
      states(readers.advertise<lattice_impact::ParticleStates>(prefix + "particle_states")),
      forces(readers.advertise<lattice_impact::ContactForces>(prefix + "contact_forces")) {}

DataStreams::DataStreams(std::size_t bodies, Readers& readers, Readers& wall_readers,
                         Readers& scalar_readers)
    : status_(readers.advertise<lattice_impact::RunStatus>("run_status", true)),
      scalars_(scalar_readers.advertise<lattice_impact::Scalars>("scalars")) {
  for (std::size_t body = 0; body < bodies; ++body) {
    bodies_.emplace_back(body == 0 ? readers : wall_readers, topics_of_body(body));
  }
}

bool DataStreams::heard(std::size_t body) const {
  return bag_ || bodies_[body].states.getNumSubscribers() > 0 ||
         bodies_[body].forces.getNumSubscribers() > 0;
}

bool DataStreams::scalars_heard() const { return bag_ || scalars_.getNumSubscribers() > 0; }

void DataStreams::open_bag(const std::string& bag) {
  if (!bag.empty()) bag_.emplace(bag);
}

/// A bag that could not be written is not written to again.
template <class Message>
void DataStreams::write(const std::string& topic, const ros::Time& stamp, const Message& message) {
  try {
    bag_->write(topic, stamp, message);
  } catch (const std::runtime_error&) {
    bag_.reset();
    throw;
  }
}

template <class Message>
void DataStreams::send(const ros::Publisher& publisher, const ros::Time& stamp,
                       const Message& message) {
  if (bag_) write(publisher.getTopic(), stamp, message);
  if (publisher.getNumSubscribers() > 0 || publisher.isLatched()) publisher.publish(message);
}

void DataStreams::send(std::size_t body, const lattice_impact::Lattice& message) {
  send(bodies_[body].lattice, message.header.stamp, message);
}

void DataStreams::send(std::size_t body, const ros::Time& stamp,
                       const RawMessage<lattice_impact::ParticleStates>& message) {
  send(bodies_[body].states, stamp, message);
}

void DataStreams::send(std::size_t body, const ros::Time& stamp,
                       const RawMessage<lattice_impact::ContactForces>& message) {
  send(bodies_[body].forces, stamp, message);
}

void DataStreams::send(const lattice_impact::RunStatus& message) {
  send(status_, message.header.stamp, message);
}

void DataStreams::send(const lattice_impact::Scalars& message) {
  send(scalars_, message.header.stamp, message);
}

std::string DataStreams::close(bool complete) {
  if (!bag_) return {};
  std::string name = bag_->finish(complete);
  bag_.reset();
  return name;
}

}  // namespace impact
