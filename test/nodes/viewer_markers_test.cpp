#include "nodes/viewer_markers.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <boost/make_shared.hpp>
#include <set>
#include <utility>

#include "nodes/viewer_colours.hpp"

namespace impact {
namespace {

using lattice_impact::RunStatus;
using visualization_msgs::Marker;
using Strains = std::array<double, 3>;

/// A triangle of three bonds with these strains, in `run`.
BodySnapshot triangle(const Strains& strains, std::uint32_t run = 0) {
  auto lattice = boost::make_shared<lattice_impact::Lattice>();
  auto states = boost::make_shared<lattice_impact::ParticleStates>();
  lattice->run = states->run = run;
  lattice->point_mass = 1.0 / 3.0;
  states->x = lattice->x = {0.0, 0.3, 0.0};
  states->y = lattice->y = {0.1, 0.1, 0.5};
  states->vx = {0.0, 0.0, 0.3};
  states->vy = {-0.2, -0.2, 0.1};
  states->time = 1.25;
  lattice->bond_first = {0, 0, 1};
  lattice->bond_second = {1, 2, 2};
  const Strains lengths{0.3, 0.4, 0.5};
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    lattice->natural_length.push_back(lengths[k] / (1.0 + strains[k]));
  }
  return {lattice, states};
}

/// Forces along y on the first points.
lattice_impact::ContactForcesConstPtr forces(const std::vector<double>& fy) {
  auto message = boost::make_shared<lattice_impact::ContactForces>();
  for (const double force : fy) {
    message->point.push_back(static_cast<std::uint32_t>(message->point.size()));
    message->fx.push_back(0.0);
    message->fy.push_back(force);
    message->total_y += force;
  }
  return message;
}

RunStatus finished_status() {
  RunStatus status;
  status.phase = RunStatus::FINISHED;
  status.answer.restitution = 0.75;
  status.answer_error.restitution = 1e-4;
  return status;
}

Snapshot snapshot(const Strains& strains, const std::vector<double>& fy = {},
                  const RunStatus& status = {}, std::uint32_t run = 0) {
  return {triangle(strains, run), forces(fy), {}, boost::make_shared<RunStatus>(status)};
}

std::vector<Marker> named(const visualization_msgs::MarkerArray& array, const std::string& name) {
  std::vector<Marker> found;
  std::copy_if(array.markers.begin(), array.markers.end(), std::back_inserter(found),
               [&](const Marker& marker) { return marker.ns == name; });
  return found;
}

Marker only(const visualization_msgs::MarkerArray& array, const std::string& name) {
  const auto found = named(array, name);
  EXPECT_EQ(found.size(), 1U) << name;
  return found.at(0);
}

std::string words(const visualization_msgs::MarkerArray& array) {
  std::string result;
  for (const Marker& marker : named(array, "text")) result += marker.text + '\n';
  return result;
}

void expect_points(const Marker& points, const lattice_impact::ParticleStates& states) {
  ASSERT_EQ(points.points.size(), states.x.size());
  for (std::size_t i = 0; i < states.x.size(); ++i) {
    EXPECT_EQ(points.points[i].x, states.x[i]);
    EXPECT_EQ(points.points[i].y, states.y[i]);
  }
}

void expect_bond_colours(const Marker& bonds, std_msgs::ColorRGBA (*colouring)(double),
                         const Strains& values) {
  ASSERT_EQ(bonds.colors.size(), 6U);
  for (std::size_t end = 0; end < bonds.colors.size(); ++end) {
    const auto expected = colouring(values[end / 2]);
    constexpr float kShown = 0.5F / 255.0F;  // half a step of a screen
    EXPECT_NEAR(bonds.colors[end].r, expected.r, kShown) << end;
    EXPECT_NEAR(bonds.colors[end].g, expected.g, kShown) << end;
    EXPECT_NEAR(bonds.colors[end].b, expected.b, kShown) << end;
  }
}

TEST(ViewerMarkers, PutThePointsWhereTheStatesAre) {
  const Snapshot state = snapshot({0.0, 0.01, -0.01});
  const auto array = ViewerMarkers().draw(state);
  expect_points(only(array, "points"), *state.disk.states);
  const auto bonds = only(array, "bonds").points;
  const auto& states = *state.disk.states;
  const std::array<std::size_t, 6> ends{0, 1, 0, 2, 1, 2};
  ASSERT_EQ(bonds.size(), ends.size());
  for (std::size_t k = 0; k < ends.size(); ++k) {
    EXPECT_EQ(std::pair(bonds[k].x, bonds[k].y), std::pair(states.x[ends[k]], states.y[ends[k]]));
  }
}

TEST(ViewerMarkers, ColourBondsByTheirStrain) {
  // 95 % of the three bonds exceed 0.8 % or less; the next round number is 1 %.
  const auto array = ViewerMarkers().draw(snapshot({0.004, -0.008, 0.02}));
  expect_bond_colours(only(array, "bonds"), disk_strain_colour, {0.4, -0.8, 2.0});
}

TEST(ViewerMarkers, KeepTheWidestRangeOfARun) {
  ViewerMarkers markers;
  markers.draw(snapshot({0.0, 0.04, 0.04}));
  EXPECT_DOUBLE_EQ(markers.strain_range(), 0.05);
  const auto array = markers.draw(snapshot({0.0, 0.01, -0.01}));
  EXPECT_DOUBLE_EQ(markers.strain_range(), 0.05);
  expect_bond_colours(only(array, "bonds"), disk_strain_colour, {0.0, 0.2, -0.2});
  std::set<std::string> labels;
  for (const Marker& label : named(array, "scale")) labels.insert(label.text);
  EXPECT_EQ(labels, (std::set<std::string>{"", "+5 %", "0", "-5 %", "strain of bonds"}));

  Snapshot next = snapshot({0.0, 0.01, -0.01}, {}, {}, 1);
  markers.draw(next);
  EXPECT_DOUBLE_EQ(markers.strain_range(), 0.01);

  markers.draw(snapshot({0.0, 0.04, 0.04}, {}, {}, 1));
  auto earlier = boost::make_shared<lattice_impact::ParticleStates>(*next.disk.states);
  earlier->time = 0.0;  // of another simulation
  next.disk.states = earlier;
  markers.draw(next);
  EXPECT_DOUBLE_EQ(markers.strain_range(), 0.01);
}

TEST(ViewerMarkers, DrawNoNoise) {
  const auto array = ViewerMarkers().draw(snapshot({0.0, 1e-15, -1e-15}));
  expect_bond_colours(only(array, "bonds"), disk_strain_colour, {0.0, 0.0, 0.0});
}

/// Its lowest and highest point, which for a force upwards are its tail and its tip.
std::pair<double, double> extent(const Marker& arrows, std::size_t arrow) {
  constexpr std::size_t kCorners = 9;
  const auto begin = arrows.points.begin() + static_cast<std::ptrdiff_t>(kCorners * arrow);
  const auto [low, high] = std::minmax_element(
      begin, begin + kCorners, [](const auto& a, const auto& b) { return a.y < b.y; });
  return {low->y, high->y};
}

TEST(ViewerMarkers, LetArrowsEndAtTheirPoints) {
  ViewerMarkers markers;
  markers.draw(snapshot({}, {0.002, 0.004}));
  EXPECT_EQ(markers.peak_force(), 0.004);
  const Marker arrows = only(markers.draw(snapshot({}, {0.001, 0.003})), "forces");
  ASSERT_EQ(arrows.points.size(), 18U);
  // Both points are at y = 0.1; the peak is 0.5 R long.
  EXPECT_DOUBLE_EQ(extent(arrows, 0).first, 0.1 - 0.5 / 4.0);
  EXPECT_DOUBLE_EQ(extent(arrows, 0).second, 0.1);
  EXPECT_DOUBLE_EQ(extent(arrows, 1).first, 0.1 - 0.5 * 3.0 / 4.0);
  EXPECT_EQ(arrows.points[0].x, 0.0);
  EXPECT_EQ(arrows.points[9].x, 0.3);

  EXPECT_EQ(only(markers.draw(snapshot({})), "forces").action, Marker::DELETE);
}

TEST(ViewerMarkers, DrawAnElasticWallInItsOwnColours) {
  Snapshot state = snapshot({0.0, 0.05, 0.05});
  const auto line = named(ViewerMarkers().draw(state), "wall");
  ASSERT_EQ(line.size(), 2U);
  EXPECT_EQ(line[0].type, Marker::LINE_LIST);
  EXPECT_EQ(line[1].action, Marker::DELETE);  // the bonds of a run before
  state.others = {triangle({0.05, -0.05, 0.0})};
  const auto wall = named(ViewerMarkers().draw(state), "wall");
  ASSERT_EQ(wall.size(), 2U);
  expect_points(wall[0], *state.others[0].states);
  expect_bond_colours(wall[1], wall_strain_colour, {1.0, -1.0, 0.0});
}

TEST(ViewerMarkers, DrawEachDiskOfARowAndForgetItAfterwards) {
  ViewerMarkers markers;
  Snapshot state = snapshot({});
  state.others = {triangle({}), triangle({0.1, 0.1, 0.1}), triangle({})};
  const auto row = named(markers.draw(state), "wall");
  ASSERT_EQ(row.size(), 6U);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(row[static_cast<std::size_t>(k)].id, k);
  expect_points(row[2], *state.others[1].states);
  state.others.resize(1);
  const auto pair = named(markers.draw(state), "wall");
  ASSERT_EQ(pair.size(), 6U);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(pair[k].action == Marker::DELETE, k >= 2) << k;
}

TEST(ViewerMarkers, FollowTheCentreOfMass) {
  ViewerMarkers markers;
  Snapshot state = snapshot({});
  EXPECT_EQ(only(markers.draw(state), "trace").action, Marker::DELETE);
  auto moved = boost::make_shared<lattice_impact::ParticleStates>(*state.disk.states);
  for (double& y : moved->y) y += 1.0;
  state.disk.states = moved;
  const Marker trace = only(markers.draw(state), "trace");
  ASSERT_EQ(trace.points.size(), 2U);
  EXPECT_NEAR(trace.points[0].y, 0.7 / 3.0, 1e-15);
  EXPECT_NEAR(trace.points[1].y, 0.7 / 3.0 + 1.0, 1e-15);
  EXPECT_NEAR(trace.points[1].x, 0.1, 1e-15);
}

TEST(ViewerMarkers, SayTheNumbers) {
  EXPECT_EQ(words(ViewerMarkers().draw(snapshot({}, {0.002, 0.004}))),
            "t = 1.25 R/c\nv = -0.100 c\nE_kin = 0.0300 M c²\nF = 0.00600 M c²/R\n\n");
  const std::string end = words(ViewerMarkers().draw(snapshot({}, {}, finished_status())));
  EXPECT_NE(end.find("e = 0.75 ± 0.0001"), std::string::npos) << end;
}

/// rviz complains of each of these faults in its own panel.
void expect_rviz_takes(const Marker& marker) {
  EXPECT_EQ(marker.header.frame_id, "world");
  EXPECT_EQ(marker.pose.orientation.w, 1.0);
  EXPECT_EQ(marker.color.a, 1.0F);
  if (marker.action == Marker::DELETE) return;
  const bool is_text = marker.type == Marker::TEXT_VIEW_FACING;
  EXPECT_EQ(marker.points.empty(), is_text);
  EXPECT_EQ(marker.text.empty(), !is_text);
  EXPECT_TRUE(marker.colors.empty() || marker.colors.size() == marker.points.size());
  if (marker.type == Marker::LINE_LIST) {
    EXPECT_GT(marker.scale.x, 0.0);
    EXPECT_EQ(std::pair(marker.scale.y, marker.scale.z), std::pair(0.0, 0.0));
    EXPECT_EQ(marker.points.size() % 2, 0U);
  }
  if (is_text) {
    EXPECT_EQ(std::pair(marker.scale.x, marker.scale.y), std::pair(0.0, 0.0));
  }
}

TEST(ViewerMarkers, SuitRvizAndItsFile) {
  const YAML::Node display = YAML::LoadFile(
      SOURCE_DIR "/launch/lattice_impact.rviz")["Visualization Manager"]["Displays"][0];
  std::set<std::string> names_of_file;
  for (const auto& name : display["Namespaces"]) names_of_file.insert(name.first.as<std::string>());

  Snapshot with_wall = snapshot({0.0, 0.05, 0.05}, {0.1}, finished_status());
  with_wall.others = {triangle({})};
  for (const Snapshot& state : {snapshot({}), with_wall}) {
    std::set<std::string> names;
    std::set<std::pair<std::string, int>> ids;
    const auto array = ViewerMarkers().draw(state);
    for (const Marker& marker : array.markers) {
      SCOPED_TRACE(marker.ns);
      expect_rviz_takes(marker);
      names.insert(marker.ns);
      EXPECT_TRUE(ids.emplace(marker.ns, marker.id).second) << marker.id;
    }
    EXPECT_EQ(names, names_of_file);
  }
}

float luminance(const std_msgs::ColorRGBA& colour) {
  return 0.2126F * colour.r + 0.7152F * colour.g + 0.0722F * colour.b;
}

/// So that the size of a strain can be read without its hue.
TEST(ViewerColours, GrowDarkerToBothSidesOfAVisibleMiddle) {
  constexpr float kBackground = 250.0F / 255.0F;
  for (const auto colouring : {disk_strain_colour, wall_strain_colour}) {
    for (const double side : {-1.0, 1.0}) {
      float last = kBackground - 0.15F;
      for (int k = 0; k <= 20; ++k) {
        const float next = luminance(colouring(side * k / 20.0));
        EXPECT_LT(next, last) << side << ' ' << k;
        last = next;
      }
    }
    EXPECT_EQ(colouring(7.0), colouring(1.0));
  }
}

}  // namespace
}  // namespace impact
