#include "mechanics/energy_ledger.hpp"

#include "mechanics/body_motion.hpp"

namespace impact {

EnergyLedger energy_ledger(const ForceField& field, const State& state, const Losses& losses) {
  const Eigen::Index all = state.position.rows();
  const Eigen::Index disk = all - field.wall_points;
  const auto velocity = state.velocity.topRows(disk);
  const BodyMotion motion = body_motion(state.position.topRows(disk), velocity);
  EnergyLedger ledger;
  ledger.kinetic_translation = 0.5 * motion.velocity.square().sum();
  ledger.kinetic_rotation = 0.5 * motion.angular_momentum * motion.spin();
  ledger.kinetic_internal = 0.5 * field.point_mass * velocity.square().sum() -
                            ledger.kinetic_translation - ledger.kinetic_rotation;
  ledger.bonds = field.bonds.potential_energy(state.position, 0, disk);
  ledger.wall = field.wall_potential_energy(state.position);
  if (field.load) ledger.load = field.load->potential_energy(state.position);
  ledger.dissipated = losses.dissipated;
  ledger.absorbed = losses.absorbed;
  if (!field.elastic_wall) return ledger;

  ledger.wall_lattice =
      0.5 * field.point_mass * state.velocity.bottomRows(field.wall_points).square().sum() +
      field.bonds.potential_energy(state.position, disk, all);
  ledger.hops = -field.elastic_wall->hops();
  ledger.hops_size = field.elastic_wall->hops_size();
  return ledger;
}

}  // namespace impact
