#pragma once

#include <ros/ros.h>

#include <string>

namespace impact {

/// The node from which the latest messages came.
class MessageSource {
 public:
  MessageSource() : last_message_(ros::WallTime::now()) {}

  /// A message has come from this node.
  void note(const std::string& node);

  bool has_spoken() const { return !node_.empty(); }

  /// s since the last message, or since the start.
  double silence() const { return (ros::WallTime::now() - last_message_).toSec(); }

  /// Whether the node is registered at the master and answers. One that was killed stays
  /// registered, and roscpp goes on looking for it.
  bool is_alive() const;

 private:
  std::string node_;
  ros::WallTime last_message_;
};

}  // namespace impact
