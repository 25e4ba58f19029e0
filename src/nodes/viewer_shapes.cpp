#include "nodes/viewer_shapes.hpp"

#include <algorithm>
#include <cmath>

#include "nodes/viewer_colours.hpp"

namespace impact {
namespace {

using Eigen::Vector2d;
using visualization_msgs::Marker;

constexpr double kLayerHeight = 0.02;  // R
constexpr double kShaftWidth = 0.022;  // R
constexpr double kHeadWidth = 0.06;    // R
constexpr double kHeadLength = 0.09;   // R
constexpr double kMostHeadPart = 0.6;  // of the arrow's length

}  // namespace

geometry_msgs::Point marker_point(const Vector2d& place) {
  geometry_msgs::Point point;
  point.x = place.x();
  point.y = place.y();
  return point;
}

Marker marker(const std_msgs::Header& header, const std::string& name, int id, std::int32_t type,
              Layer layer) {
  Marker result;
  result.header = header;
  result.ns = name;
  result.id = id;
  result.type = type;
  result.action = Marker::ADD;
  result.pose.position.z = kLayerHeight * static_cast<double>(layer);
  result.pose.orientation.w = 1.0;
  result.color.a = 1.0F;
  return result;
}

Marker lines(const std_msgs::Header& header, const std::string& name, int id, Layer layer,
             double width, std_msgs::ColorRGBA colour) {
  Marker result = marker(header, name, id, Marker::LINE_LIST, layer);
  result.scale.x = width;
  result.color = colour;
  result.color.a = 1.0F;
  return result;
}

Marker triangles(const std_msgs::Header& header, const std::string& name, int id, Layer layer) {
  Marker result = marker(header, name, id, Marker::TRIANGLE_LIST, layer);
  result.scale.x = result.scale.y = result.scale.z = 1.0;
  return result;
}

Marker text(const std_msgs::Header& header, const std::string& name, int id, const Vector2d& place,
            double height, const std::string& words) {
  Marker result = marker(header, name, id, Marker::TEXT_VIEW_FACING, Layer::kText);
  result.pose.position.x = place.x();
  result.pose.position.y = place.y();
  result.scale.z = height;
  result.color = colour(0.1F, 0.1F, 0.1F);
  result.text = words;
  return result;
}

void add_triangle(const Vector2d& a, const Vector2d& b, const Vector2d& c,
                  const std_msgs::ColorRGBA& colour, Marker& triangles) {
  for (const Vector2d& corner : {a, b, c}) {
    triangles.points.push_back(marker_point(corner));
    triangles.colors.push_back(colour);
  }
}

void add_arrow(const Vector2d& tip, const Vector2d& length, const std_msgs::ColorRGBA& colour,
               Marker& triangles) {
  const double size = length.norm();
  const Vector2d along = length / size;
  const Vector2d across{-along.y(), along.x()};
  const double scale = std::min(1.0, kMostHeadPart * size / kHeadLength);
  const Vector2d neck = tip - scale * kHeadLength * along;
  const Vector2d half_head = 0.5 * scale * kHeadWidth * across;
  const Vector2d half_shaft = 0.5 * scale * kShaftWidth * across;
  const Vector2d tail = tip - length;
  add_triangle(tip, neck + half_head, neck - half_head, colour, triangles);
  add_triangle(tail - half_shaft, neck - half_shaft, neck + half_shaft, colour, triangles);
  add_triangle(tail - half_shaft, neck + half_shaft, tail + half_shaft, colour, triangles);
}

void add_centre(const Vector2d& place, double radius, Marker& triangles) {
  constexpr int kCorners = 32;
  constexpr double kRim = 1.15;  // of the radius, to the outer edge of the circle
  const auto black = colour(0.0F, 0.0F, 0.0F);
  const auto white = colour(1.0F, 1.0F, 1.0F);
  const auto corner = [&](int k, double distance) -> Vector2d {
    const double angle = 2.0 * M_PI * k / kCorners;
    return place + distance * Vector2d{std::cos(angle), std::sin(angle)};
  };
  for (int k = 0; k < kCorners; ++k) {
    const bool is_black = 4 * k / kCorners % 2 == 0;
    add_triangle(place, corner(k, radius), corner(k + 1, radius), is_black ? black : white,
                 triangles);
    add_triangle(corner(k, radius), corner(k, kRim * radius), corner(k + 1, kRim * radius), black,
                 triangles);
    add_triangle(corner(k, radius), corner(k + 1, kRim * radius), corner(k + 1, radius), black,
                 triangles);
  }
}

void delete_if_empty(Marker& marker) {
  if (marker.points.empty()) marker.action = Marker::DELETE;
}

}  // namespace impact
