#include "mechanics/force_field.hpp"

namespace impact {

double ForceField::evaluate(const PointArray& position, const PointArray& velocity,
                            PointArray& force) {
  force.setZero();
  const double dissipated_power = bonds.add_forces(position, velocity, force);
  if (wall) wall->add_forces(position, force);
  if (load) load->add_forces(force);
  if (hold) hold->apply(force);
  return dissipated_power;
}

double ForceField::potential_energy(const PointArray& position) const {
  double energy = bonds.potential_energy(position);
  if (wall) energy += wall->potential_energy(position);
  if (load) energy += load->potential_energy(position);
  return energy;
}

std::vector<std::string> ForceField::terms() const {
  std::vector<std::string> names{bonds.name()};
  if (wall) names.emplace_back("potential wall");
  if (load) names.emplace_back("compression load");
  if (hold) names.emplace_back("rotation hold");
  return names;
}

}  // namespace impact
