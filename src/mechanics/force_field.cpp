#include "mechanics/force_field.hpp"

#include <algorithm>

namespace impact {
namespace {

void add_wall_and_load(ForceField& field, const PointArray& position, PointArray& force) {
  if (field.wall) field.wall->add_forces(position, force);
  if (field.elastic_wall) field.elastic_wall->add_forces(position, force);
  if (field.load) field.load->add_forces(force);
}

void constrain(ForceField& field, PointArray& force) {
  if (field.hold) field.hold->apply(force);
  if (field.supports) field.supports->apply(force);
}

/// Sets to zero what couples a supported coordinate to others.
void uncouple(const Supports& supports, std::size_t points,
              std::vector<Eigen::Triplet<double>>& entries) {
  std::vector<bool> held(2 * points, false);
  for (const int axis : {0, 1}) {
    for (const std::int32_t point : supports.held(axis)) {
      held[static_cast<std::size_t>(axis) * points + static_cast<std::size_t>(point)] = true;
    }
  }
  const auto is_held = [&](int place) { return held[static_cast<std::size_t>(place)]; };
  for (auto& entry : entries) {
    if (entry.row() == entry.col()) continue;
    if (is_held(entry.row()) || is_held(entry.col())) entry = {entry.row(), entry.col(), 0.0};
  }
}

}  // namespace

Losses ForceField::evaluate(const PointArray& position, const PointArray& velocity,
                            PointArray& force) {
  ++evaluations;
  Losses power;
  power.dissipated = bonds.evaluate(position, velocity, force);
  add_wall_and_load(*this, position, force);
  if (viscous_boundary) power.absorbed = viscous_boundary->add_forces(velocity, force);
  constrain(*this, force);
  return power;
}

void ForceField::evaluate_undamped(const PointArray& position, PointArray& force) {
  ++evaluations;
  bonds.evaluate_elastic(position, force);
  add_wall_and_load(*this, position, force);
  constrain(*this, force);
}

std::vector<Eigen::Triplet<double>> ForceField::damping(int axis) const {
  std::vector<Eigen::Triplet<double>> entries = bonds.damping();
  if (viscous_boundary) {
    for (const ViscousBoundary::Dashpot& dashpot : viscous_boundary->dashpots()) {
      entries.emplace_back(dashpot.point, dashpot.point, dashpot.coefficient(axis));
    }
  }
  if (!supports) return entries;
  std::vector<bool> held(static_cast<std::size_t>(bonds.points()), false);
  for (const std::int32_t point : supports->held(axis)) {
    held[static_cast<std::size_t>(point)] = true;
  }
  const auto is_held = [&](const Eigen::Triplet<double>& entry) {
    return held[static_cast<std::size_t>(entry.row())] ||
           held[static_cast<std::size_t>(entry.col())];
  };
  entries.erase(std::remove_if(entries.begin(), entries.end(), is_held), entries.end());
  return entries;
}

std::vector<Eigen::Triplet<double>> ForceField::stiffness(const PointArray& position) const {
  const auto points = static_cast<std::int32_t>(position.rows());
  std::vector<Eigen::Triplet<double>> entries = bonds.stiffness(position);
  if (supports) uncouple(*supports, static_cast<std::size_t>(points), entries);
  if (!wall) return entries;
  for (std::int32_t i = 0; i < points; ++i) {
    const double along_y = wall->stiffness(wall->force_at(position(i, 1)));
    entries.emplace_back(points + i, points + i, along_y);
  }
  return entries;
}

bool ForceField::shifts_freely(int axis) const {
  const bool supported = supports && !supports->held(axis).empty();
  return !supported && (axis == 0 || !wall);
}

double ForceField::potential_energy(const PointArray& position) const {
  double energy = bonds.potential_energy(position) + wall_potential_energy(position);
  if (load) energy += load->potential_energy(position);
  return energy;
}

double ForceField::wall_potential_energy(const PointArray& position) const {
  if (wall) return wall->potential_energy(position);
  return elastic_wall ? elastic_wall->potential_energy(position) : 0.0;
}

const WallContact* ForceField::contact() const {
  if (wall) return &*wall;
  return elastic_wall ? &*elastic_wall : nullptr;
}

std::vector<std::string> ForceField::terms() const {
  std::vector<std::string> names{bonds.name()};
  if (wall) names.emplace_back("potential wall");
  if (elastic_wall) names.emplace_back("elastic wall");
  if (load) names.emplace_back("compression load");
  if (viscous_boundary) names.emplace_back("viscous boundary");
  if (velocity_reset) names.emplace_back("velocity reset");
  if (hold) names.emplace_back("rotation hold");
  if (supports) names.emplace_back("supports");
  return names;
}

}  // namespace impact
