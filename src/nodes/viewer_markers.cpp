#include "nodes/viewer_markers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "nodes/mean.hpp"
#include "nodes/viewer_colours.hpp"
#include "nodes/viewer_shapes.hpp"

namespace impact {
namespace {

using Eigen::Vector2d;
using lattice_impact::Lattice;
using lattice_impact::ParticleStates;
using lattice_impact::RunStatus;
using std_msgs::Header;
using visualization_msgs::Marker;
using Colouring = std_msgs::ColorRGBA (*)(double);

constexpr double kBondWidth = 0.24;      // of the points' spacing
constexpr double kPointSize = 0.24;      // of the points' spacing
constexpr double kWallHalfWidth = 1.35;  // R
constexpr double kLongestArrow = 0.5;    // R
constexpr double kLeastForce = 1e-3;     // of the peak; less is not drawn
constexpr double kLeastStrain = 1e-10;   // far above rounding
constexpr double kQuantile = 0.95;       // of the bonds; the few at the contact are strained more
constexpr double kTraceStep = 0.01;      // R
constexpr double kTextHeight = 0.12;     // R

Vector2d place(const ParticleStates& states, std::size_t point) {
  return {states.x[point], states.y[point]};
}

double kinetic_energy(const Lattice& lattice, const ParticleStates& states) {
  double sum = 0.0;
  for (std::size_t i = 0; i < states.vx.size(); ++i) {
    sum += states.vx[i] * states.vx[i] + states.vy[i] * states.vy[i];
  }
  return 0.5 * lattice.point_mass * sum;
}

/// R, of a disk or square of these points, which fill π R² for 1 M.
double spacing(const Lattice& lattice) { return std::sqrt(M_PI * lattice.point_mass); }

std::vector<double> strains(const BodySnapshot& body) {
  std::vector<double> result;
  for (std::size_t k = 0; k < body.lattice->natural_length.size(); ++k) {
    const Vector2d bond = place(*body.states, body.lattice->bond_second[k]) -
                          place(*body.states, body.lattice->bond_first[k]);
    result.push_back(bond.norm() / body.lattice->natural_length[k] - 1.0);
  }
  return result;
}

/// The size that a part `kQuantile` of the values does not exceed.
double usual_size(std::vector<double> values) {
  if (values.empty()) return 0.0;
  for (double& value : values) value = std::abs(value);
  const auto last = static_cast<double>(values.size() - 1);
  const auto rank = values.begin() + static_cast<std::ptrdiff_t>(kQuantile * last);
  std::nth_element(values.begin(), rank, values.end());
  return *rank;
}

/// 1, 2 or 5 times a power of ten, no less than `value`.
double rounded_up(double value) {
  constexpr double kRounding = 1.0 - 1e-9;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (value * kRounding <= digit * power) return digit * power;
  }
  return 10.0 * power;
}

Marker points(const Header& header, const std::string& name, const BodySnapshot& body,
              const std_msgs::ColorRGBA& colour) {
  Marker result = marker(header, name, 0, Marker::SPHERE_LIST, Layer::kPoints);
  const double size = kPointSize * spacing(*body.lattice);
  result.scale.x = result.scale.y = result.scale.z = size;
  result.color = colour;
  for (std::size_t i = 0; i < body.states->x.size(); ++i) {
    result.points.push_back(marker_point(place(*body.states, i)));
  }
  return result;
}

Marker bonds(const Header& header, const std::string& name, const BodySnapshot& body,
             const std::vector<double>& strains, double range, Colouring colouring) {
  Marker result = lines(header, name, 1, Layer::kBonds, kBondWidth * spacing(*body.lattice));
  for (std::size_t k = 0; k < strains.size(); ++k) {
    const auto colour = colouring(strains[k] / range);
    for (const std::uint32_t end : {body.lattice->bond_first[k], body.lattice->bond_second[k]}) {
      result.points.push_back(marker_point(place(*body.states, end)));
      result.colors.push_back(colour);
    }
  }
  return result;
}

/// The surface of a wall without a lattice, hatched as in a drawing.
Marker wall_line(const Header& header) {
  constexpr double kWidth = 0.02;  // R
  constexpr int kHatches = 30;
  constexpr double kHatch = 2.0 * kWallHalfWidth / kHatches;  // R
  Marker result = lines(header, "wall", 0, Layer::kBonds, kWidth, colour(0.35F, 0.35F, 0.35F));
  result.points = {marker_point({-kWallHalfWidth, 0.0}), marker_point({kWallHalfWidth, 0.0})};
  for (int k = 1; k <= kHatches; ++k) {
    const double x = k * kHatch - kWallHalfWidth;
    result.points.push_back(marker_point({x, 0.0}));
    result.points.push_back(marker_point({x - kHatch, -kHatch}));
  }
  return result;
}

/// e, where the run has ended with one.
std::string restitution(const RunStatus& status) {
  if (status.phase != RunStatus::FINISHED || !std::isfinite(status.answer.restitution)) return {};
  std::string e = fmt::format("e = {:.6g}", status.answer.restitution);
  if (!std::isfinite(status.answer_error.restitution)) return e;
  return fmt::format("{} ± {:.1g}", e, status.answer_error.restitution);
}

void add_text(const Header& header, const Snapshot& snapshot, std::vector<Marker>& markers) {
  constexpr double kTop = 2.62;     // R
  constexpr double kLine = 0.2;     // R
  constexpr double kColumn = 1.25;  // R
  const ParticleStates& states = *snapshot.disk.states;
  // A marker each, so that none moves with the width of another.
  const std::array<std::pair<Vector2d, std::string>, 5> texts{
      {{{-kColumn, kTop}, fmt::format("t = {:.2f} R/c", states.time)},
       {{0.0, kTop}, fmt::format("v = {:#.3g} c", mean(states.vy))},
       {{kColumn, kTop},
        fmt::format("E_kin = {:#.3g} M c²", kinetic_energy(*snapshot.disk.lattice, states))},
       {{-kColumn, kTop - kLine}, fmt::format("F = {:#.3g} M c²/R", snapshot.forces->total_y)},
       {{0.0, kTop - kLine}, restitution(*snapshot.status)}}};
  for (std::size_t k = 0; k < texts.size(); ++k) {
    const auto& [at, words] = texts[k];
    markers.push_back(text(header, "text", static_cast<int>(k), at, kTextHeight, words));
    if (words.empty()) markers.back().action = Marker::DELETE;
  }
}

}  // namespace

Vector2d centre_of_mass(const ParticleStates& states) { return {mean(states.x), mean(states.y)}; }

/// Another simulation counts its runs from 0 too.
void ViewerMarkers::begin_if_new(const ParticleStates& states) {
  const bool goes_on = run_ == states.run && states.time >= time_;
  time_ = states.time;
  if (goes_on) return;
  run_ = states.run;
  strain_range_ = kLeastStrain;
  peak_force_ = 0.0;
  trace_.clear();
}

void ViewerMarkers::take_in(const Snapshot& snapshot, const std::vector<double>& strains) {
  strain_range_ = std::max(strain_range_, rounded_up(std::max(usual_size(strains), kLeastStrain)));
  const lattice_impact::ContactForces& forces = *snapshot.forces;
  for (std::size_t k = 0; k < forces.point.size(); ++k) {
    peak_force_ = std::max(peak_force_, std::hypot(forces.fx[k], forces.fy[k]));
  }
  const Vector2d centre = centre_of_mass(*snapshot.disk.states);
  if (trace_.empty() || (centre - trace_.back()).norm() > kTraceStep) trace_.push_back(centre);
}

visualization_msgs::MarkerArray ViewerMarkers::draw(const Snapshot& snapshot) {
  begin_if_new(*snapshot.disk.states);
  Header header = snapshot.disk.states->header;
  header.frame_id = "world";
  const std::vector<double> disk_strains = strains(snapshot.disk);
  take_in(snapshot, disk_strains);

  visualization_msgs::MarkerArray array;
  const auto dark = colour(0.3F, 0.3F, 0.33F);
  array.markers = {
      points(header, "points", snapshot.disk, dark),
      bonds(header, "bonds", snapshot.disk, disk_strains, strain_range_, disk_strain_colour),
      forces(header, snapshot), trace(header)};
  Marker centre = triangles(header, "centre of mass", 0, Layer::kCentre);
  add_centre(centre_of_mass(*snapshot.disk.states), 0.05, centre);
  array.markers.push_back(centre);
  add_others(header, snapshot.others, array.markers);
  add_scale(header, !snapshot.others.empty(), array.markers);
  add_text(header, snapshot, array.markers);
  for (Marker& marker : array.markers) {
    if (marker.type != Marker::TEXT_VIEW_FACING) delete_if_empty(marker);
  }
  return array;
}

/// What the disk meets, and nothing where a run before had more.
void ViewerMarkers::add_others(const Header& header, const std::vector<BodySnapshot>& others,
                               std::vector<Marker>& markers) {
  int id = 0;
  const auto add = [&](Marker marker) {
    marker.id = id++;
    markers.push_back(std::move(marker));
  };
  for (const BodySnapshot& body : others) {
    add(points(header, "wall", body, colour(0.45F, 0.38F, 0.25F)));
    add(bonds(header, "wall", body, strains(body), strain_range_, wall_strain_colour));
  }
  if (others.empty()) add(wall_line(header));
  const int drawn = id;
  while (id < most_of_others_) add(lines(header, "wall", id, Layer::kBonds, 0.0));
  most_of_others_ = std::max(most_of_others_, drawn);
}

Marker ViewerMarkers::trace(const Header& header) const {
  Marker result = lines(header, "trace", 0, Layer::kTrace, 0.012, colour(0.0F, 0.0F, 0.0F));
  for (std::size_t k = 1; k < trace_.size(); ++k) {
    result.points.push_back(marker_point(trace_[k - 1]));
    result.points.push_back(marker_point(trace_[k]));
  }
  return result;
}

Marker ViewerMarkers::forces(const Header& header, const Snapshot& snapshot) const {
  Marker result = triangles(header, "forces", 0, Layer::kForces);
  const lattice_impact::ContactForces& forces = *snapshot.forces;
  for (std::size_t k = 0; k < forces.point.size(); ++k) {
    const Vector2d force{forces.fx[k], forces.fy[k]};
    if (force.norm() <= kLeastForce * peak_force_) continue;
    add_arrow(place(*snapshot.disk.states, forces.point[k]), kLongestArrow / peak_force_ * force,
              colour(0.0F, 0.55F, 0.40F), result);
  }
  return result;
}

void ViewerMarkers::add_scale(const Header& header, bool has_wall_lattice,
                              std::vector<Marker>& markers) const {
  constexpr double kLeft = 1.65;   // R
  constexpr double kWidth = 0.12;  // R, of a column
  constexpr double kBottom = 0.3;  // R
  constexpr double kHeight = 1.5;  // R
  constexpr int kSteps = 100;
  Marker bar = triangles(header, "scale", 0, Layer::kBonds);
  const auto add_column = [&](double left, Colouring colouring) {
    for (int k = 0; k < kSteps; ++k) {
      const Vector2d low{left, kBottom + kHeight * k / kSteps};
      const Vector2d high{left + kWidth, kBottom + kHeight * (k + 1) / kSteps};
      const auto colour = colouring((2.0 * k + 1.0) / kSteps - 1.0);
      add_triangle(low, {high.x(), low.y()}, high, colour, bar);
      add_triangle(low, high, {low.x(), high.y()}, colour, bar);
    }
  };
  add_column(kLeft, disk_strain_colour);
  if (has_wall_lattice) add_column(kLeft + kWidth, wall_strain_colour);
  markers.push_back(bar);
  const std::string end = fmt::format("{:.3g} %", 100.0 * strain_range_);
  const std::array<std::pair<double, std::string>, 4> labels{
      {{-1.0, "-" + end}, {0.0, "0"}, {1.0, "+" + end}, {1.25, "strain of bonds"}}};
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const auto& [value, words] = labels[k];
    const bool is_title = value > 1.0;
    const Vector2d at{kLeft + (is_title ? kWidth : 3.5 * kWidth + 0.1),
                      kBottom + 0.5 * kHeight * (value + 1.0)};
    markers.push_back(text(header, "scale", static_cast<int>(k) + 1, at, kTextHeight, words));
    const bool is_known = strain_range_ > kLeastStrain;
    if (!is_known && std::abs(value) == 1.0) markers.back().action = Marker::DELETE;
  }
}

}  // namespace impact
