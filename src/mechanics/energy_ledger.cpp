#include "mechanics/energy_ledger.hpp"

#include "mechanics/body_motion.hpp"

namespace impact {

EnergyLedger energy_ledger(const ForceField& field, const State& state, double dissipated) {
  const BodyMotion motion = body_motion(state.position, state.velocity);
  EnergyLedger ledger;
  ledger.kinetic_translation = 0.5 * motion.velocity.square().sum();
  ledger.kinetic_rotation = 0.5 * motion.angular_momentum * motion.spin();
  ledger.kinetic_internal = 0.5 * field.point_mass * state.velocity.square().sum() -
                            ledger.kinetic_translation - ledger.kinetic_rotation;
  ledger.bonds = field.bonds.potential_energy(state.position);
  if (field.wall) ledger.wall = field.wall->potential_energy(state.position);
  if (field.load) ledger.load = field.load->potential_energy(state.position);
  ledger.dissipated = dissipated;
  return ledger;
}

}  // namespace impact
