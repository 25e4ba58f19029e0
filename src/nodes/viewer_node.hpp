#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>

#include <string>
#include <vector>

#include "nodes/viewer_markers.hpp"
#include "nodes/viewer_snapshot.hpp"

namespace impact {

/// Draws a simulation, live or replayed: `markers` for rviz, latched, and `contact_wrench`, the
/// total force of the wall on the disk as a standard message. It keeps up with the newest state and
/// drops the others; the simulation does not wait for it. Frame `world`; 1 R is 1 m, 1 M c²/R is 1
/// N. Once a second it tells `/diagnostics` what the latest status says of the run.
class ViewerNode {
 public:
  ViewerNode();

  /// Until interrupted.
  void run();

 private:
  void publish(const Snapshot& snapshot);
  void publish_frame(const Snapshot& snapshot);

  ros::NodeHandle node_;
  SnapshotAssembly assembly_;
  ViewerMarkers markers_of_;
  ros::Publisher markers_;
  ros::Publisher wrench_;
  ros::Publisher frames_;
  diagnostic_updater::Updater diagnostics_;
  lattice_impact::RunStatusConstPtr status_;  ///< the latest
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace impact
