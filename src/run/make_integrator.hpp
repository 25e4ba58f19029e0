#pragma once

#include <memory>

#include "mechanics/integrator.hpp"
#include "run/resolution.hpp"
#include "scene/scene.hpp"

namespace impact {

/// Largest stable step of a method of fixed step (R/c) on a lattice with these contacts, see
/// Spectrum::with_contacts().
double step_limit(IntegratorKind integrator, const Spectrum& lattice, double contact_rate = 0.0,
                  double inner_share = 0.0);

/// Makes an integrator of fixed step, for one run or for lanes.
/// @throw std::logic_error for a kind that is none.
template <class Field>
std::unique_ptr<FixedStepIntegrator<Field>> make_fixed(IntegratorKind integrator);

/// @throw InputError for an integrator that the program does not have: rk8pd where a program
/// does without GSL, bdf where the package was built without SUNDIALS.
void refuse_missing_integrator(const Scene& scene);

/// Makes the integrator of a resolution, which the program has.
std::unique_ptr<Integrator> make_integrator(const Scene& scene, const Resolution& resolution,
                                            double sound_speed);

}  // namespace impact
