#include "mechanics/force_field.hpp"

#include "mechanics/body_motion.hpp"

namespace impact {

Losses ForceField::evaluate(const PointArray& position, const PointArray& velocity,
                            PointArray& force) {
  ++evaluations;
  Losses power;
  power.dissipated = bonds.evaluate(position, velocity, force);
  for_each_term([&](auto& term) { term.add_forces(position, force); });
  add_damping_of_terms(velocity, force, power);
  for_each_term([&](auto& term) { term.constrain(force); });
  return power;
}

Losses ForceField::evaluate_damping(const PointArray& velocity, PointArray& force) {
  Losses power;
  power.dissipated = bonds.evaluate_damping(velocity, force);
  add_damping_of_terms(velocity, force, power);
  for_each_term([&](auto& term) { term.constrain(force); });
  return power;
}

void ForceField::add_damping_of_terms(const PointArray& velocity, PointArray& force,
                                      Losses& power) const {
  for_each_term([&](const auto& term) {
    const impact::Losses taken = term.add_damping_forces(velocity, force);
    power.dissipated += taken.dissipated;
    power.absorbed += taken.absorbed;
  });
}

void ForceField::evaluate_undamped(const PointArray& position, PointArray& force) {
  ++evaluations;
  bonds.evaluate_elastic(position, force);
  for_each_term([&](auto& term) { term.add_forces(position, force); });
  for_each_term([&](auto& term) { term.constrain(force); });
}

bool ForceField::has_local_terms() const {
  bool local = !bonds.has_two_laws();
  for_each_term([&](const auto& term) {
    local = local && std::is_same_v<std::decay_t<decltype(term)>, PotentialWall>;
  });
  return local;
}

MatrixEntries ForceField::damping(int axis) const {
  MatrixEntries entries = bonds.damping();
  for_each_term([&](const auto& term) { term.add_damping(axis, entries); });
  for_each_term([&](const auto& term) { term.constrain_damping(axis, entries); });
  return entries;
}

MatrixEntries ForceField::stiffness(const PointArray& position) const {
  MatrixEntries entries;
  find_stiffness(position, entries);
  return entries;
}

void ForceField::find_stiffness(const PointArray& position, MatrixEntries& entries) const {
  bonds.find_stiffness(position, entries);
  for_each_term([&](const auto& term) { term.add_stiffness(position, entries); });
  const auto points = static_cast<std::size_t>(position.rows());
  for_each_term([&](const auto& term) { term.constrain_stiffness(points, entries); });
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
  const Contact* const met = contact();
  return met != nullptr ? met->potential_energy(position) : 0.0;
}

EnergyLedger ForceField::ledger(const impact::State& state, const impact::Losses& losses) const {
  EnergyLedger ledger;
  enter_free(first_body(), state, ledger);
  ledger.dissipated = losses.dissipated;
  ledger.absorbed = losses.absorbed;
  for (const Body& other : others) {
    if (other.is_free) {
      enter_free(other, state, ledger);
    } else {
      ledger.wall_lattice += kinetic_energy(other, state) + bond_energy(other, state);
    }
  }
  for_each_term([&](const auto& term) { term.enter(state.position, ledger); });
  return ledger;
}

void ForceField::enter_free(const Body& body, const impact::State& state,
                            EnergyLedger& ledger) const {
  const BodyMotion motion = body_motion(body.rows_of(state.position), body.rows_of(state.velocity));
  const double mass = mass_of(body);
  const double translation = 0.5 * mass * motion.velocity.square().sum();
  const double rotation = 0.5 * mass * motion.angular_momentum * motion.spin();
  ledger.kinetic_translation += translation;
  ledger.kinetic_rotation += rotation;
  ledger.kinetic_internal += kinetic_energy(body, state) - translation - rotation;
  ledger.bonds += bond_energy(body, state);
}

double ForceField::reduced_mass() const {
  double mass = 0.0;
  for (const Body& other : others) {
    if (other.is_free) mass += mass_of(other);
  }
  return mass == 0.0 ? 1.0 : impact::reduced_mass(mass);
}

double ForceField::kinetic_energy(const Body& body, const impact::State& state) const {
  return 0.5 * point_mass * body.rows_of(state.velocity).square().sum();
}

double ForceField::bond_energy(const Body& body, const impact::State& state) const {
  return bonds.potential_energy(state.position, body.first, body.first + body.points);
}

const Contact* ForceField::contact() const {
  if (wall) return &*wall;
  if (disk_contacts) return &*disk_contacts;
  return elastic_wall ? &*elastic_wall : nullptr;
}

std::vector<std::string> ForceField::terms() const {
  std::vector<std::string> names{bonds.name()};
  for_each_term([&](const auto& term) { names.emplace_back(std::decay_t<decltype(term)>::kName); });
  return names;
}

}  // namespace impact
