#pragma once

#include <geometry_msgs/Point.h>
#include <std_msgs/ColorRGBA.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>

#include <Eigen/Core>
#include <cstdint>
#include <string>

namespace impact {

/// From the back to the front.
enum class Layer { kBonds, kPoints, kTrace, kForces, kCentre, kText };

geometry_msgs::Point marker_point(const Eigen::Vector2d& place);

/// A marker of `type` with only the fields that every type has. rviz complains of others.
visualization_msgs::Marker marker(const std_msgs::Header& header, const std::string& name, int id,
                                  std::int32_t type, Layer layer);

visualization_msgs::Marker lines(const std_msgs::Header& header, const std::string& name, int id,
                                 Layer layer, double width, std_msgs::ColorRGBA colour = {});

/// Filled triangles, each point with a colour of its own, in which they are drawn as they are: rviz
/// shades those of one colour.
visualization_msgs::Marker triangles(const std_msgs::Header& header, const std::string& name,
                                     int id, Layer layer);

/// Centred at `place`.
visualization_msgs::Marker text(const std_msgs::Header& header, const std::string& name, int id,
                                const Eigen::Vector2d& place, double height,
                                const std::string& words);

void add_triangle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                  const std_msgs::ColorRGBA& colour, visualization_msgs::Marker& triangles);

/// An arrow that ends at `tip`.
void add_arrow(const Eigen::Vector2d& tip, const Eigen::Vector2d& length,
               const std_msgs::ColorRGBA& colour, visualization_msgs::Marker& triangles);

/// The sign for a centre of mass: a circle with quarters in black and white.
void add_centre(const Eigen::Vector2d& place, double radius, visualization_msgs::Marker& triangles);

/// rviz draws no marker without points, and complains: what is empty is taken away.
void delete_if_empty(visualization_msgs::Marker& marker);

}  // namespace impact
