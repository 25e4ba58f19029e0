#pragma once

#include <ros/ros.h>

#include "lattice/lattice.hpp"
#include "measure/contact_report.hpp"
#include "mechanics/state.hpp"

namespace impact {

/// Copies in standard messages for rviz and other viewers, made only while somebody looks:
/// `markers` (points, bonds and the wall's surface) and `contact_wrench` (total contact force).
/// Frame: `world`; 1 R = 1 m, 1 M c²/R = 1 N.
class Viewer {
 public:
  explicit Viewer(ros::NodeHandle& node);
  void publish(const ros::Time& stamp, const Lattice& lattice, const State& state,
               const ContactReport& report) const;

 private:
  ros::Publisher markers_;
  ros::Publisher wrench_;
};

}  // namespace impact
