#include "mechanics/force_field.hpp"

#include "mechanics/body_motion.hpp"

namespace impact {

Losses ForceField::evaluate(const PointArray& position, const PointArray& velocity,
                            PointArray& force) {
  ++evaluations;
  Losses power;
  power.dissipated = bonds.evaluate(position, velocity, force);
  for_each_term([&](auto& term) { term.add_forces(position, force); });
  for_each_term([&](const auto& term) {
    const impact::Losses taken = term.add_damping_forces(velocity, force);
    power.dissipated += taken.dissipated;
    power.absorbed += taken.absorbed;
  });
  for_each_term([&](auto& term) { term.constrain(force); });
  return power;
}

void ForceField::evaluate_undamped(const PointArray& position, PointArray& force) {
  ++evaluations;
  bonds.evaluate_elastic(position, force);
  for_each_term([&](auto& term) { term.add_forces(position, force); });
  for_each_term([&](auto& term) { term.constrain(force); });
}

MatrixEntries ForceField::damping(int axis) const {
  MatrixEntries entries = bonds.damping();
  for_each_term([&](const auto& term) { term.add_damping(axis, entries); });
  for_each_term([&](const auto& term) { term.constrain_damping(axis, entries); });
  return entries;
}

MatrixEntries ForceField::stiffness(const PointArray& position) const {
  MatrixEntries entries = bonds.stiffness(position);
  for_each_term([&](const auto& term) { term.add_stiffness(position, entries); });
  const auto points = static_cast<std::size_t>(position.rows());
  for_each_term([&](const auto& term) { term.constrain_stiffness(points, entries); });
  return entries;
}

bool ForceField::damped() const {
  bool damped = bonds.damped();
  for_each_term(
      [&](const auto& term) { damped = damped || std::decay_t<decltype(term)>::kIsDamping; });
  return damped;
}

bool ForceField::shifts_freely(int axis) const {
  bool freely = true;
  for_each_term([&](const auto& term) { freely = freely && term.shifts_freely(axis); });
  return freely;
}

double ForceField::potential_energy(const PointArray& position) const {
  EnergyLedger ledger;
  for_each_term([&](const auto& term) { term.enter(position, ledger); });
  return bonds.potential_energy(position) + ledger.wall + ledger.load;
}

double ForceField::wall_potential_energy(const PointArray& position) const {
  EnergyLedger ledger;
  for_each_term([&](const auto& term) { term.enter(position, ledger); });
  return ledger.wall;
}

EnergyLedger ForceField::ledger(const impact::State& state, const impact::Losses& losses) const {
  const Eigen::Index all = state.position.rows();
  const Eigen::Index disk = all - wall_points;
  const auto velocity = state.velocity.topRows(disk);
  const BodyMotion motion = body_motion(state.position.topRows(disk), velocity);
  EnergyLedger ledger;
  ledger.kinetic_translation = 0.5 * motion.velocity.square().sum();
  ledger.kinetic_rotation = 0.5 * motion.angular_momentum * motion.spin();
  ledger.kinetic_internal = 0.5 * point_mass * velocity.square().sum() -
                            ledger.kinetic_translation - ledger.kinetic_rotation;
  ledger.bonds = bonds.potential_energy(state.position, 0, disk);
  ledger.dissipated = losses.dissipated;
  ledger.absorbed = losses.absorbed;
  if (wall_points > 0) {
    ledger.wall_lattice = 0.5 * point_mass * state.velocity.bottomRows(wall_points).square().sum() +
                          bonds.potential_energy(state.position, disk, all);
  }
  for_each_term([&](const auto& term) { term.enter(state.position, ledger); });
  return ledger;
}

const WallContact* ForceField::contact() const {
  if (wall) return &*wall;
  return elastic_wall ? &*elastic_wall : nullptr;
}

std::vector<std::string> ForceField::terms() const {
  std::vector<std::string> names{bonds.name()};
  for_each_term([&](const auto& term) { names.emplace_back(std::decay_t<decltype(term)>::kName); });
  return names;
}

}  // namespace impact
