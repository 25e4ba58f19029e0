#include "mechanics/force_field.hpp"

namespace impact {

Losses ForceField::evaluate(const PointArray& position, const PointArray& velocity,
                            PointArray& force) {
  force.setZero();
  Losses power;
  power.dissipated = bonds.add_forces(position, velocity, force);
  if (wall) wall->add_forces(position, force);
  if (elastic_wall) elastic_wall->add_forces(position, force);
  if (load) load->add_forces(force);
  if (viscous_boundary) power.absorbed = viscous_boundary->add_forces(velocity, force);
  if (hold) hold->apply(force);
  if (supports) supports->apply(force);
  return power;
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
