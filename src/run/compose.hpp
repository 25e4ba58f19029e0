#pragma once

#include <memory>

#include "mechanics/force_field.hpp"
#include "mechanics/state.hpp"
#include "reduced/modal_correction.hpp"
#include "run/bodies.hpp"
#include "run/expected_time.hpp"
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
  /// Of the method `modal`, for all its runs.
  std::shared_ptr<ModalCorrectionOnDemand> modal_correction =
      std::make_shared<ModalCorrectionOnDemand>();
};

/// @throw InputError for what is known before the bodies are made: for a disk of more than 10⁶
/// points by recipe, as refuse_missing_integrator() and, where they are made by recipes,
/// refuse_if_too_long().
void refuse_impossible(const Scene& scene);

/// @throw InputError as refuse_impossible(), for a lattice that cannot be used, and for a given
/// step beyond the stability bound of the lattice and its damping, and as refuse_if_too_long().
Composition compose(const Scene& scene);
/// With the bodies of this scene or one of the same bodies.
Composition compose(const Scene& scene, std::shared_ptr<const Bodies> bodies);
std::shared_ptr<const Composition> compose_shared(const Scene& scene);

/// Where a run made so starts.
State start_of(const Composition& composition, const Resolution& resolution);

}  // namespace impact
