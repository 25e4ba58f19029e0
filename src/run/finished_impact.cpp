#include "run/finished_impact.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/rotation_hold.hpp"

namespace impact {
namespace {

/// Of the spin of the disk, relative, in this time (R/c) of flight. The damping acts on what turns:
/// I ω′ = −ω Σ η d², with the lengths d of the bonds.
double lost_of_spin(const Run& run, double time) {
  const ForceField& field = run.system().field();
  if (!field.bonds.damped()) return 0.0;
  const Body disk = field.first_body();
  const RotationHold rotation(disk.rows_of(run.state().position));
  PointArray velocity = PointArray::Zero(field.bonds.points(), 2);
  velocity.middleRows(disk.first, disk.points) = rotation.direction();
  PointArray force(velocity.rows(), 2);
  const double power = BondForces(field.bonds).evaluate_damping(velocity, force);
  const double inertia = field.point_mass * rotation.direction().square().sum();
  return std::expm1(power / inertia * time);
}

}  // namespace

Restitution after_the_tail(const Run& run, Restitution measured) {
  const double energy = run.system().field().wall_potential_energy(run.state().position);
  const double gain = run.system().field().reduced_mass() * energy / measured.velocity_after;
  measured.velocity_after += gain;
  measured.restitution = -measured.velocity_after / measured.velocity_before;
  measured.impulse += gain;
  const double part = energy / measured.energy_before;
  measured.normal_energy += part;
  measured.energy_restitution =
      std::sqrt(measured.energy_restitution * measured.energy_restitution + part);
  return measured;
}

FinishedImpact finished_impact(const Run& run, const Restitution& measured) {
  FinishedImpact impact;
  impact.measured = measured;
  impact.step = run.system().step_size();
  impact.steps = run.state().step;
  impact.time = run.state().time;
  impact.tail_error = run.tail_error();
  const ForceField& field = run.system().field();
  const Contact& contact = *field.contact();
  impact.error_by_hops =
      0.5 * (contact.hops_size() + contact.turned()) / field.impact_energy(measured.velocity_after);
  impact.step_reduced = run.system().halvings() > 0;
  impact.stiffest_contact = run.system().stiffest_contact();
  impact.lost_of_spin = lost_of_spin(run, std::max(0.0, impact.time - measured.contact_end));
  impact.not_separated = run.has_flag(Flag::kNotSeparated);
  impact.folded = run.has_flag(Flag::kFolded);
  impact.cut_off = run.has_flag(Flag::kCutOff);
  return impact;
}

}  // namespace impact
