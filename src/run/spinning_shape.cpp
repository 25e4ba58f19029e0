#include "run/spinning_shape.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scene/scene_parameters.hpp"
#include "statics/equilibrium_solver.hpp"

namespace impact {

PointArray spinning_shape(const Scene& scene, const Bodies& bodies) {
  // Of the centrifugal force at the rim: what is left of it is all that the disk breathes with.
  constexpr double kNegligible = 1e-6;
  constexpr double kRounding = 1e-14;  // of the bonds' forces, over k_a R
  const PointArray& reference = bodies.disk().points;
  const double mass = 1.0 / static_cast<double>(reference.rows());
  const double spin = scene.impact.spin;
  ForceField field{BondForces(bodies.disk(), {scene.material.k_a, scene.material.k_b, 0.0}), mass};
  field.centrifugal.emplace(spin, mass);
  field.hold.emplace(reference);
  const State start{0.0, 0, reference, PointArray::Zero(reference.rows(), 2)};
  EquilibriumSearch search(
      std::move(field), start,
      std::max(kNegligible * mass * spin * spin, kRounding * scene.material.k_a));
  solve(search);
  if (!search.found()) {
    throw bad_value("impact.spin", fmt::format("{}", spin),
                    "a spin at which this disk holds together");
  }
  return search.state().position;
}

}  // namespace impact
