#pragma once

#include <string>

#include "scene/scene.hpp"

namespace impact {

/// The answer of a scene, e or ξ, by other means than those of Run and ErrorControl: only the
/// lattice, the start and the forces are the same.
struct ReferenceAnswer {
  double value;
  double error;         ///< relative, as two computations differ; infinite: not known
  std::string method;   ///< empty: none
  std::string failure;  ///< why there is none; empty: there is one
};

/// To about a tenth of the scene's numerics.error, if that can be had.
/// - Collision: starts with a thousandth of the wall's energy that is negligible to the scene, and
///   ends when the disk, however it turned, could no longer touch the wall. By rk8pd with two
///   tolerances, a tenth and a hundredth of the wanted error, at most 10⁻⁶ and 10⁻⁷, or with stiff
///   damping on the potential wall by ExtrapolatedDamping with two steps: on an elastic wall two
///   runs of fixed step may agree by chance, since contacts that hop from bond to bond take away
///   their order. If the two differ by more than a tenth of the wanted error, a third one follows.
/// - Contact: Newton's method in long double, see precise_strain(). Loads above 10⁻³ k_a R, which
///   may leave a choice of equilibria, also begin with damped motion to near rest.
ReferenceAnswer reference_answer(const Scene& scene);

}  // namespace impact
