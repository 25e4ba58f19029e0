#pragma once

namespace impact {

/// Where the energy is, in M c². The total is constant to the integrator's order. Kinetic terms and
/// bonds are the disk's, of two disks those of both.
struct EnergyLedger {
  double kinetic_translation = 0.0;  ///< of the centre of mass
  double kinetic_rotation = 0.0;     ///< L²/(2 I) about the centre of mass
  double kinetic_internal = 0.0;     ///< the rest of the kinetic energy
  double bonds = 0.0;
  double wall = 0.0;
  double load = 0.0;          ///< P, or the weight, times the height of the centre of mass
  double dissipated = 0.0;    ///< by damping, since the start
  double wall_lattice = 0.0;  ///< kinetic and bond energy of an elastic wall
  double absorbed = 0.0;      ///< at the boundary of an elastic wall, since the start
  double hops = 0.0;       ///< taken out where contacts passed from bond to bond, since the start
  double hops_size = 0.0;  ///< the same, each by its size; not part of the total

  double kinetic() const { return kinetic_translation + kinetic_rotation + kinetic_internal; }
  double total() const {
    return kinetic() + bonds + wall + load + dissipated + wall_lattice + absorbed + hops;
  }
};

}  // namespace impact
