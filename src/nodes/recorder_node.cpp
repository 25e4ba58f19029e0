#include "nodes/recorder_node.hpp"

#include <fmt/format.h>
#include <lattice_impact/ContactForces.h>
#include <lattice_impact/Lattice.h>
#include <lattice_impact/LawFit.h>
#include <lattice_impact/ParticleStates.h>
#include <lattice_impact/Restitution.h>
#include <lattice_impact/Scalars.h>
#include <lattice_impact/Strain.h>

#include <algorithm>
#include <boost/function.hpp>
#include <stdexcept>
#include <type_traits>

#include "nodes/body_topics.hpp"
#include "nodes/program.hpp"
#include "nodes/raw_message.hpp"
#include "nodes/readers.hpp"

namespace impact {
namespace {

constexpr double kFarewell = 2.0;  // s of silence, after an interruption

/// The status is read; of the others only the run.
template <class Message>
using Recorded = std::conditional_t<std::is_same_v<Message, lattice_impact::RunStatus>, Message,
                                    RawMessage<Message>>;

template <class Message>
void count_in(Inventory& inventory, const std::string& topic, const Message& message) {
  inventory.add(topic, message.run);
}
void count_in(Inventory& inventory, const std::string& /*topic*/,
              const lattice_impact::RunStatus& message) {
  inventory.add(message);
}

template <class Message>
constexpr bool is_result() {
  return std::is_same_v<Message, lattice_impact::Strain> ||
         std::is_same_v<Message, lattice_impact::Restitution> ||
         std::is_same_v<Message, lattice_impact::LawFit>;
}

template <class Message>
constexpr bool is_state() {
  return std::is_same_v<Message, lattice_impact::ParticleStates> ||
         std::is_same_v<Message, lattice_impact::ContactForces>;
}

/// Never 0, whatever the simulated time is, and rising as a replay needs it.
ros::Time time_of_arrival() {
  const ros::WallTime now = ros::WallTime::now();
  return {now.sec, now.nsec};
}

}  // namespace

RecorderNode::RecorderNode(const RecorderNodeParameters& parameters)
    : parameters_(parameters),
      bag_(parameters.bag),
      acknowledged_(node_.advertise<lattice_impact::Acknowledged>("acknowledged", 0, true)) {
  for (const std::string& name : parameters.results_of) {
    results_announced_[node_.resolveName(name)].run = 0;
  }
}

void RecorderNode::run() {
  subscribers_.push_back(node_.subscribe("acknowledged", 0, &RecorderNode::take_acknowledgement,
                                         this, ros::TransportHints().tcpNoDelay()));
  for (std::size_t body = 0; body < kMostBodies; ++body) {
    const std::string prefix = topics_of_body(body);
    record<lattice_impact::Lattice>(prefix + "lattice");
    record<lattice_impact::ParticleStates>(prefix + "particle_states");
    record<lattice_impact::ContactForces>(prefix + "contact_forces");
  }
  record<lattice_impact::Scalars>("scalars");
  record<lattice_impact::Strain>("strain");
  record<lattice_impact::Restitution>("restitution");
  record<lattice_impact::LawFit>("law_fit");
  record<lattice_impact::RunStatus>("run_status");

  while (!is_done() && !nothing_more_comes()) {
    serve_callbacks();
    acknowledge_finished_runs();
  }
  finish();
}

template <class Message>
void RecorderNode::record(const std::string& topic) {
  const std::string full_name = node_.resolveName(topic);
  using Event = ros::MessageEvent<const Recorded<Message>>;
  const boost::function<void(const Event&)> take = [this, topic, full_name](const Event& event) {
    if (!is_result<Message>()) simulation_.note(event.getPublisherName());
    bag_.write(full_name, time_of_arrival(), *event.getMessage(), event.getConnectionHeaderPtr());
    count_in(inventory_, topic, *event.getMessage());
    ++results_[full_name];
    if (is_state<Message>()) acknowledge_states(event.getMessage()->run);
  };
  subscribers_.push_back(node_.subscribe<const Event&>(topic, 0, take, ros::VoidConstPtr(),
                                                       ros::TransportHints().tcpNoDelay()));
}

void RecorderNode::take_acknowledgement(const lattice_impact::Acknowledged& message) {
  const auto reader = results_announced_.find(message.reader);
  if (reader != results_announced_.end()) reader->second = message;
}

void RecorderNode::acknowledge_states(std::uint32_t run) {
  if (++state_messages_ % Pacing::kStep != 0) return;
  const std::pair<std::uint32_t, std::uint32_t> recorded{run, inventory_.states(run)};
  if (recorded <= recorded_ || recorded.second == 0) return;
  recorded_ = recorded;
  acknowledge(run, recorded.second - 1);
}

void RecorderNode::acknowledge(std::uint32_t run, std::uint32_t sequence) {
  lattice_impact::Acknowledged message;
  message.reader = ros::this_node::getName();
  message.run = run;
  message.sequence = sequence;
  acknowledged_.publish(message);
}

bool RecorderNode::has_results_of(std::uint32_t run) const {
  const std::pair<std::uint32_t, std::uint32_t> end{run, inventory_.states(run)};
  return std::all_of(results_announced_.begin(), results_announced_.end(), [&](const auto& reader) {
    const lattice_impact::Acknowledged& announced = reader.second;
    if (std::pair{announced.run, announced.sequence} < end) return false;
    for (std::size_t k = 0; k < announced.result_topics.size(); ++k) {
      const auto recorded = results_.find(announced.result_topics[k]);
      const std::uint64_t count = recorded == results_.end() ? 0 : recorded->second;
      if (count < announced.results.at(k)) return false;
    }
    return true;
  });
}

/// The last run is acknowledged when the bag is closed.
void RecorderNode::acknowledge_finished_runs() {
  while (inventory_.has_all_of(first_open_run_) && has_results_of(first_open_run_)) {
    const std::uint32_t run = first_open_run_++;
    if (is_done()) return;
    acknowledge(run, inventory_.states(run));
  }
}

bool RecorderNode::is_done() const { return first_open_run_ > inventory_.last_run(); }

bool RecorderNode::nothing_more_comes() const {
  if (asked_to_end()) return simulation_.silence() > kFarewell;
  if (!simulation_.has_spoken()) return simulation_.silence() > parameters_.timeout;
  return simulation_.silence() > parameters_.patience && !simulation_is_there();
}

bool RecorderNode::simulation_is_there() const {
  return subscribers_.back().getNumPublishers() > 0 && simulation_.is_alive();
}

void RecorderNode::finish() {
  if (!simulation_.has_spoken()) {
    bag_.discard();
    throw std::runtime_error(
        asked_to_end() ? "nothing was recorded"
                       : fmt::format("no message for {} s (timeout)", parameters_.timeout));
  }
  std::vector<std::string> problems = inventory_.problems();
  if (problems.empty() && !is_done()) problems.emplace_back("results are missing");
  for (const std::string& problem : problems) ROS_ERROR("%s", problem.c_str());
  const std::string file = bag_.finish(problems.empty());
  if (!problems.empty()) {
    throw std::runtime_error("the recording is not complete: kept as " + file);
  }
  ROS_INFO("recorded %u run(s) in %s", first_open_run_, file.c_str());
  acknowledge(first_open_run_ - 1, inventory_.states(first_open_run_ - 1));
  const ros::WallTime start = ros::WallTime::now();
  while (simulation_is_there() && !asked_to_end() &&
         (ros::WallTime::now() - start).toSec() < parameters_.timeout) {
    serve_callbacks();
  }
}

}  // namespace impact
