#pragma once

#include <ros/ros.h>

#include "measure/contact_report.hpp"
#include "run/run.hpp"

namespace impact {

/// Copies in standard messages for rviz and other viewers, made only while somebody looks:
/// `markers` (points and bonds of the disk and of an elastic wall, or the wall's surface) and
/// `contact_wrench` (total contact force). Frame: `world`; 1 R = 1 m, 1 M c²/R = 1 N.
class Viewer {
 public:
  explicit Viewer(ros::NodeHandle& node);
  void publish(const ros::Time& stamp, const Run& run, const ContactReport& report) const;

 private:
  ros::Publisher markers_;
  ros::Publisher wrench_;
};

}  // namespace impact
