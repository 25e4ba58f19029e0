#include "nodes/replay_node.hpp"

#include <fmt/format.h>
#include <lattice_impact/ContactForces.h>
#include <lattice_impact/Lattice.h>
#include <lattice_impact/ParticleStates.h>
#include <lattice_impact/RunStatus.h>
#include <lattice_impact/Scalars.h>
#include <topic_tools/shape_shifter.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

#include "nodes/bag_reading.hpp"
#include "nodes/inventory.hpp"
#include "nodes/program.hpp"
#include "scene/parameter_table.hpp"

namespace impact {
namespace {

using Position = std::pair<std::uint32_t, std::int64_t>;

constexpr double kLongestSleep = 0.1;  // s

template <class Message>
bool is_of(const rosbag::ConnectionInfo& connection) {
  return connection.datatype == ros::message_traits::DataType<Message>::value();
}

template <class... Messages>
bool is_of_one(const rosbag::ConnectionInfo& connection) {
  return (is_of<Messages>(connection) || ...);
}

/// What a simulation publishes: results come from the analysis.
bool is_data(const rosbag::ConnectionInfo& connection) {
  return is_of_one<lattice_impact::Lattice, lattice_impact::ParticleStates,
                   lattice_impact::ContactForces, lattice_impact::RunStatus,
                   lattice_impact::Scalars>(connection);
}

/// "/a" for "a", "a/" and "/a"; "" for the root.
std::string prefix_of(const std::string& name_space) {
  const std::size_t first = name_space.find_first_not_of('/');
  if (first == std::string::npos) return "";
  return "/" + name_space.substr(first, name_space.find_last_not_of('/') + 1 - first);
}

bool is_below(const std::string& prefix, const std::string& topic) {
  return topic.compare(0, prefix.size() + 1, prefix + "/") == 0;
}

/// Whether it is not of a second body.
bool is_of_disk(const std::string& topic) { return topic.find('/') == std::string::npos; }

/// None for a message that says nothing of it, or cannot be read.
std::optional<Position> position_of(const rosbag::MessageInstance& message) {
  try {
    if (const auto state = message.instantiate<lattice_impact::ParticleStates>()) {
      return Position{state->run, state->sequence};
    }
    const auto status = message.instantiate<lattice_impact::RunStatus>();
    if (status && has_ended(*status)) return Position{status->run, status->states};
  } catch (const ros::Exception&) {
  }
  return std::nullopt;
}

void open(const ReplayNodeParameters& parameters, rosbag::Bag& bag) {
  try {
    open_to_read(parameters.bag, bag);
  } catch (const InputError& error) {
    throw InputError(fmt::format("bag: {}", error.what()));
  }
  rosbag::View all(bag);
  const std::set<std::string> found = simulations_in(all);
  if (found.empty()) throw InputError(fmt::format("bag: {} holds no run", parameters.bag));
  const std::string prefix = prefix_of(parameters.recorded_in);
  if (found.count(prefix.empty() ? "/" : prefix) > 0) return;
  throw bad_value("ns", parameters.recorded_in,
                  fmt::format("{}, as in {}", fmt::join(found, " or "), parameters.bag));
}

}  // namespace

void check_bag(const ReplayNodeParameters& parameters) {
  rosbag::Bag bag;
  open(parameters, bag);
}

ReplayNode::ReplayNode(const ReplayNodeParameters& parameters)
    : parameters_(parameters),
      prefix_(prefix_of(parameters.recorded_in)),
      readers_(node_, parameters.wait_for),
      others_(node_, {}),
      pacing_(node_, parameters.acknowledged_by) {
  open(parameters, bag_);
  view_.addQuery(bag_, [this](const rosbag::ConnectionInfo* connection) {
    return is_data(*connection) && is_below(prefix_, connection->topic);
  });
  for (const rosbag::ConnectionInfo* connection : view_.getConnections()) advertise(*connection);
}

std::string ReplayNode::topic_of(const std::string& recorded) const {
  return recorded.substr(prefix_.size() + 1);
}

void ReplayNode::advertise(const rosbag::ConnectionInfo& connection) {
  if (publishers_.count(connection.topic) > 0) return;
  const std::string topic = topic_of(connection.topic);
  ros::AdvertiseOptions options(topic, 0, connection.md5sum, connection.datatype,
                                connection.msg_def);
  options.latch = is_of_one<lattice_impact::Lattice, lattice_impact::RunStatus>(connection);
  const bool all_listen = is_of_disk(topic) && !is_of<lattice_impact::Scalars>(connection);
  publishers_[connection.topic] = (all_listen ? readers_ : others_).advertise(options);
}

void ReplayNode::run() {
  readers_.wait(parameters_.timeout);
  pacing_.wait_for_links(parameters_.timeout);
  begin_ = view_.getBeginTime();
  start_ = ros::WallTime::now();
  for (const rosbag::MessageInstance& message : view_) {
    wait_until(message.getTime());
    if (asked_to_end() || !readers_are_there()) return;
    publish(message);
    keep_pace();
  }
  wait_for(latest_, parameters_.timeout);
  ros::WallDuration(parameters_.linger).sleep();
}

void ReplayNode::wait_until(const ros::Time& recorded) const {
  const double due = (recorded - begin_).toSec() / parameters_.rate;
  while (!asked_to_end()) {
    const double left = due - (ros::WallTime::now() - start_).toSec();
    if (left <= 0.0) return;
    ros::WallDuration(std::min(left, kLongestSleep)).sleep();
    ros::spinOnce();
  }
}

void ReplayNode::publish(const rosbag::MessageInstance& message) {
  const auto content = message.instantiate<topic_tools::ShapeShifter>();
  publishers_.at(message.getTopic()).publish(*content);
  if (is_of_disk(topic_of(message.getTopic()))) latest_ = position_of(message).value_or(latest_);
}

void ReplayNode::keep_pace() {
  ros::spinOnce();
  const auto& [run, sequence] = latest_;
  if (sequence < Pacing::kWindow || run == unpaced_run_) return;
  if (!wait_for({run, sequence - Pacing::kWindow}, parameters_.patience)) unpaced_run_ = run;
}

/// False when nothing more is acknowledged.
bool ReplayNode::wait_for(const Position& position, double patience) {
  const ros::WallTime start = ros::WallTime::now();
  while (!pacing_.is_acknowledged(position.first, position.second)) {
    const double silence = std::min(pacing_.silence(), (ros::WallTime::now() - start).toSec());
    if (silence > patience || asked_to_end() || !readers_are_there()) return false;
    serve_callbacks();
  }
  return true;
}

bool ReplayNode::readers_are_there() const {
  return std::all_of(
      parameters_.wait_for.begin(), parameters_.wait_for.end(),
      [this](const std::string& name) { return readers_.hears(node_.resolveName(name)); });
}

}  // namespace impact
