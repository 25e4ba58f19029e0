#include "nodes/viewer_node.hpp"

#include <fmt/format.h>
#include <geometry_msgs/WrenchStamped.h>
#include <tf2_msgs/TFMessage.h>

#include "nodes/body_topics.hpp"
#include "nodes/program.hpp"

namespace impact {
namespace {

constexpr double kHighestRate = 60.0;  // pictures/s
constexpr std::uint32_t kQueue = 4;    // messages

using diagnostic_updater::DiagnosticStatusWrapper;
using lattice_impact::RunStatus;

void diagnose(const RunStatus& run, DiagnosticStatusWrapper& diagnosis) {
  const std::string name = fmt::format("run {} of {}", run.run + 1, run.runs);
  if (run.phase == RunStatus::FAILED) {
    diagnosis.summary(DiagnosticStatusWrapper::ERROR, name + ": " + run.error);
  } else if (run.phase == RunStatus::INTERRUPTED) {
    diagnosis.summary(DiagnosticStatusWrapper::WARN, name + ": interrupted");
  } else {
    diagnosis.summary(DiagnosticStatusWrapper::OK, name);
  }
  diagnosis.add("progress", run.progress);
  diagnosis.add("states published", run.states);
  diagnosis.add("energy error", run.energy.error);
}

}  // namespace

ViewerNode::ViewerNode()
    : markers_(node_.advertise<visualization_msgs::MarkerArray>("markers", 1, true)),
      wrench_(node_.advertise<geometry_msgs::WrenchStamped>("contact_wrench", 1)),
      frames_(node_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true)) {
  using lattice_impact::ParticleStatesConstPtr;
  const auto add = [this](const auto& message) { assembly_.add(message); };
  subscribers_.push_back(node_.subscribe<RunStatus>(
      "run_status", kQueue, [this](const lattice_impact::RunStatusConstPtr& status) {
        assembly_.add(status);
        status_ = status;
      }));
  subscribers_.push_back(
      node_.subscribe<lattice_impact::ContactForces>("contact_forces", kQueue, add));
  for (std::size_t body = 0; body < kMostBodies; ++body) {
    const std::string prefix = topics_of_body(body);
    subscribers_.push_back(
        node_.subscribe<lattice_impact::Lattice>(prefix + "lattice", kQueue, add));
    subscribers_.push_back(node_.subscribe<lattice_impact::ParticleStates>(
        prefix + "particle_states", kQueue,
        [this, body](const ParticleStatesConstPtr& states) { assembly_.add(body, states); }));
  }
  diagnostics_.setHardwareID("none");
  diagnostics_.add("simulation", [this](auto& diagnosis) { diagnose(*status_, diagnosis); });
}

void ViewerNode::run() {
  ros::WallRate rate(kHighestRate);
  while (!asked_to_end()) {
    serve_callbacks();
    if (status_) diagnostics_.update();
    const auto snapshot = assembly_.take();
    if (!snapshot) continue;
    publish(*snapshot);
    rate.sleep();
  }
}

void ViewerNode::publish(const Snapshot& snapshot) {
  markers_.publish(markers_of_.draw(snapshot));
  geometry_msgs::WrenchStamped wrench;
  wrench.header = snapshot.forces->header;
  wrench.header.frame_id = "world";
  wrench.wrench.force.x = snapshot.forces->total_x;
  wrench.wrench.force.y = snapshot.forces->total_y;
  wrench_.publish(wrench);
  publish_frame(snapshot);
}

/// As if it stood still, without a stamp: simulated time may go back, which moving frames may not.
void ViewerNode::publish_frame(const Snapshot& snapshot) {
  const Eigen::Vector2d centre = centre_of_mass(*snapshot.disk.states);
  tf2_msgs::TFMessage frames;
  frames.transforms.resize(1);
  geometry_msgs::TransformStamped& frame = frames.transforms.front();
  frame.header.frame_id = "world";
  frame.child_frame_id = node_.resolveName("centre_of_mass").substr(1);
  frame.transform.translation.x = centre.x();
  frame.transform.translation.y = centre.y();
  frame.transform.rotation.w = 1.0;
  frames_.publish(frames);
}

}  // namespace impact
