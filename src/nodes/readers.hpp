#pragma once

#include <ros/ros.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace impact {

/// The nodes that must not miss a message. What is published through it is seen by each of them
/// from the first message on, since wait() returns only when each has subscribed to each topic.
class Readers {
 public:
  /// `names` of nodes, resolved in the namespace of `node`.
  Readers(ros::NodeHandle& node, const std::vector<std::string>& names);

  /// Advertises a topic, with an unlimited queue.
  template <class Message>
  ros::Publisher advertise(const std::string& topic, bool latch = false) {
    ros::AdvertiseOptions options;
    options.init<Message>(topic, 0);
    options.latch = latch;
    return advertise(options);
  }
  /// The same of any type of message; what to do when subscribers come and go is filled in here.
  ros::Publisher advertise(ros::AdvertiseOptions options);

  /// Waits until every reader has subscribed to every topic, or until `interrupted`.
  /// @throw std::runtime_error after `timeout` seconds, with the readers and topics that are
  /// missing.
  void wait(double timeout);

  /// @throw std::runtime_error when a reader that was there has gone, with its name.
  void check() const;

  /// Whether a node subscribes to one of the topics.
  bool hears(const std::string& name) const;

  /// Names of all nodes that subscribe to one of the topics.
  std::set<std::string> subscribers() const;

 private:
  bool all_there() const;
  std::string missing() const;

  ros::NodeHandle node_;
  std::vector<std::string> names_;
  std::map<std::string, std::set<std::string>> subscribers_;  ///< names, by topic
};

/// Holds a publisher of states back until its readers have taken in what it sent.
class Pacing {
 public:
  /// States that it may be ahead of the slowest reader.
  static constexpr std::int64_t kWindow = 100;
  /// States of a run of which a reader acknowledges one, and besides the end.
  static constexpr std::uint32_t kStep = 10;

  Pacing(ros::NodeHandle& node, const std::vector<std::string>& names);

  /// Waits until the acknowledgements of all readers can be heard, or until `interrupted`: one sent
  /// before would be lost.
  /// @throw std::runtime_error after `timeout` seconds.
  void wait_for_links(double timeout);

  /// Waits until every reader has acknowledged the message `sequence` of `run` or a later one, or
  /// until `interrupted`.
  /// @throw std::runtime_error when one that has not was there and is not any more, as `is_there`
  /// says of its name, or when nothing is acknowledged for `timeout` seconds.
  void wait(std::uint32_t run, std::int64_t sequence, double timeout,
            const std::function<bool(const std::string&)>& is_there);

  /// Whether it waits for the acknowledgements of the node with this name.
  bool heeds(const std::string& name) const { return acknowledged_.count(name) > 0; }

  /// Whether every reader has.
  bool is_acknowledged(std::uint32_t run, std::int64_t sequence) const;

  /// s since a reader acknowledged something, or since wait_for_links().
  double silence() const { return (ros::WallTime::now() - last_news_).toSec(); }

 private:
  using Position = std::pair<std::int64_t, std::int64_t>;  // run, sequence

  std::map<std::string, Position> acknowledged_;  ///< by reader
  std::set<std::string> seen_;                    ///< readers that were there
  ros::WallTime last_news_;
  ros::Subscriber subscriber_;
};

}  // namespace impact
