#include "nodes/viewer.hpp"

#include <geometry_msgs/WrenchStamped.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <cstdint>

namespace impact {
namespace {

constexpr const char* kFrame = "world";
constexpr double kWallHalfWidth = 1.5;  // R

geometry_msgs::Point marker_point(double x, double y) {
  geometry_msgs::Point point;
  point.x = x;
  point.y = y;
  return point;
}

visualization_msgs::Marker marker(const ros::Time& stamp, int id, std::int32_t type, double size,
                                  float red, float green, float blue) {
  visualization_msgs::Marker result;
  result.header.stamp = stamp;
  result.header.frame_id = kFrame;
  result.id = id;
  result.type = type;
  result.pose.orientation.w = 1.0;
  result.scale.x = result.scale.y = result.scale.z = size;
  result.color.r = red;
  result.color.g = green;
  result.color.b = blue;
  result.color.a = 1.0F;
  return result;
}

void add_bonds(const Lattice& lattice, std::size_t first_row, visualization_msgs::Marker& bonds,
               const visualization_msgs::Marker& points) {
  for (const Bond& bond : lattice.bonds) {
    bonds.points.push_back(points.points[first_row + static_cast<std::size_t>(bond.first)]);
    bonds.points.push_back(points.points[first_row + static_cast<std::size_t>(bond.second)]);
  }
}

visualization_msgs::MarkerArray markers(const ros::Time& stamp, const Run& run) {
  using visualization_msgs::Marker;
  const State& state = run.state();
  const auto disk_points = static_cast<std::size_t>(run.lattice().points.rows());
  const double spacing = std::sqrt(M_PI / static_cast<double>(disk_points));
  Marker points = marker(stamp, 0, Marker::SPHERE_LIST, 0.4 * spacing, 0.85F, 0.35F, 0.1F);
  for (Eigen::Index i = 0; i < state.position.rows(); ++i) {
    points.points.push_back(marker_point(state.position(i, 0), state.position(i, 1)));
  }
  Marker bonds = marker(stamp, 1, Marker::LINE_LIST, 0.08 * spacing, 0.25F, 0.35F, 0.5F);
  add_bonds(run.lattice(), 0, bonds, points);
  visualization_msgs::MarkerArray array;
  if (run.wall_lattice() != nullptr) {
    add_bonds(*run.wall_lattice(), disk_points, bonds, points);
    array.markers = {points, bonds};
    return array;
  }
  Marker wall = marker(stamp, 2, Marker::LINE_LIST, 0.2 * spacing, 0.1F, 0.1F, 0.1F);
  wall.points = {marker_point(-kWallHalfWidth, 0.0), marker_point(kWallHalfWidth, 0.0)};

  array.markers = {points, bonds, wall};
  return array;
}

}  // namespace

Viewer::Viewer(ros::NodeHandle& node)
    : markers_(node.advertise<visualization_msgs::MarkerArray>("markers", 1)),
      wrench_(node.advertise<geometry_msgs::WrenchStamped>("contact_wrench", 1)) {}

void Viewer::publish(const ros::Time& stamp, const Run& run, const ContactReport& report) const {
  if (markers_.getNumSubscribers() > 0) markers_.publish(markers(stamp, run));
  if (wrench_.getNumSubscribers() > 0) {
    geometry_msgs::WrenchStamped wrench;
    wrench.header.stamp = stamp;
    wrench.header.frame_id = kFrame;
    wrench.wrench.force.x = report.total.x();
    wrench.wrench.force.y = report.total.y();
    wrench_.publish(wrench);
  }
}

}  // namespace impact
