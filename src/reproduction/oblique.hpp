#pragma once

#include <vector>

#include "reproduction/reproduction.hpp"

namespace impact {

/// How stiff a wall is, and how fast a disk with k_a = 1 comes.
struct WallAndSpeed {
  double k_a;          ///< of the wall, M c²/R²
  double velocity;     ///< c
  double least = 0.0;  ///< tan γ from which on it is thrown
};

/// Impacts at an angle γ from the normal: on every wall at every tan γ. By default at the velocity
/// of Kuninaka and Hayakawa on walls from ten times as hard as the disk to a hundred times as soft,
/// and at half of it on the softest. Steeper impacts on the soft walls are left out: those fold, so
/// that the energy balance breaks or the disk stays caught in the wall.
struct ObliqueThrows {
  std::vector<WallAndSpeed> walls{{10.0, 0.1},      {1.0, 0.1},       {0.1, 0.1, 2.0},
                                  {0.03, 0.1, 4.0}, {0.01, 0.1, 4.0}, {0.01, 0.05, 4.0}};
  std::vector<double> tangents{0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 7.0, 10.0};
};

/// What they simulate, over all seeds.
std::vector<Scene> scenes_of_oblique(int lattices, const ObliqueThrows& throws = {});

/// Not of the paper: e over tan γ, the slope of the surface under the contact, and what e is
/// according to it, see restitution_on_slope() (oblique.csv, oblique_impacts.csv). e₀ is that of a
/// straight impact of the same lattices with the velocity v cos γ. A lattice counts where both
/// impacts have a sound answer, see is_sound().
void reproduce_oblique(const Reproduction& reproduction, const ObliqueThrows& throws = {});

}  // namespace impact
