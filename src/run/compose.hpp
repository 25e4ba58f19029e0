#pragma once

#include <memory>

#include "mechanics/force_field.hpp"
#include "mechanics/state.hpp"
#include "run/bodies.hpp"
#include "run/resolution.hpp"
#include "scene/scene.hpp"

namespace impact {

/// A scene made ready: the terms that it has, and no others, at the start. All runs of the scene
/// share one.
struct Composition {
  std::shared_ptr<const Bodies> bodies;
  ForceField field;
  State initial;
  Rates rates;                 ///< with an estimate of the sound speed
  Resolution resolution;       ///< the first, see first_resolution()
  double expected_time = 0.0;  ///< rough time at which the run's question is answered, R/c
};

/// @throw InputError for a lattice that cannot be used, and for a given step beyond the stability
/// bound of the lattice and its damping.
Composition compose(const Scene& scene);
/// With the bodies of this scene or one of the same bodies.
Composition compose(const Scene& scene, std::shared_ptr<const Bodies> bodies);
std::shared_ptr<const Composition> compose_shared(const Scene& scene);

/// Where a run made so starts.
State start_of(const Composition& composition, const Resolution& resolution);

/// The height (R), not below `height`, from which the disk comes down in a whole number of
/// intervals between resets of an elastic wall; where there are none, `height`.
double on_whole_resets(const Scene& scene, double height);

/// The energy of the potential wall that counts as none: numerics.error/100 of the kinetic energy
/// at the start. In M c².
double negligible_wall_energy(const Scene& scene);

/// The fraction of a kinetic energy that counts as none: numerics.error/100.
double negligible_fraction(const Scene& scene);

}  // namespace impact
