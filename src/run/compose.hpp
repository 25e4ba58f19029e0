#pragma once

#include <optional>

#include "lattice/lattice.hpp"
#include "mechanics/force_field.hpp"
#include "mechanics/spectrum.hpp"
#include "mechanics/state.hpp"
#include "scene/scene.hpp"

namespace impact {

/// A scene made ready: the terms that it has, and no others, at the start.
struct Composition {
  Lattice lattice;                      ///< of the disk, or of a stretched rectangle
  std::optional<Lattice> wall_lattice;  ///< of an elastic wall, above whose surface y = 0 lies
  ForceField field;
  State initial;
  Spectrum spectrum;
  double step = 0.0;           ///< R/c
  double sound_speed = 0.0;    ///< estimate of c_s for step sizes and waiting times, c
  double expected_time = 0.0;  ///< rough time at which the run's question is answered, R/c
};

/// @throw InputError for a lattice that cannot be used, and for a given step beyond the stability
/// bound of the lattice and its damping.
Composition compose(const Scene& scene);

/// The energy of the potential wall that counts as none: numerics.error/100 of the kinetic energy
/// at the start. In M c².
double negligible_wall_energy(const Scene& scene);

}  // namespace impact
