#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace impact {

/// The scene of this number from the random scenes of a seed: of five in turn one contact, one
/// collision with an elastic wall and three with the potential wall. Drawn are, log-uniform, the
/// points of the disk (50 … 2000), the speed (0.003 … 0.1 c) or load (10⁻³ … 10⁻² M c²/R), a (100 …
/// 1000 /R), in half of the scenes k_b (10⁻³ … 10³ M c²/R⁴, else 0) and, of those with the
/// potential wall, η* (0.1 … 1000, else 0); the placement, the lattice's seed and an elastic wall's
/// boundary and gap. Such a wall has the disk's bonds and number density.
Scene random_scene(std::uint64_t seed, int number);

/// The errors that are asked of a scene, falling: 10⁻³, 10⁻⁵, 10⁻⁷; with an elastic wall, whose
/// hops limit it, 10⁻², 10⁻³, 10⁻⁴.
std::vector<double> asked_errors(const Scene& scene);

/// The answer of a scene, e or ξ, to far below the errors that are asked.
struct ReferenceAnswer {
  double value;
  double error;         ///< relative difference from another method's; infinite: neither is known
  std::string failure;  ///< of one of them; empty: none
};

/// From two methods that share nothing but the forces:
/// - contact: Newton's method, and damped motion to rest (η* = N, ImplicitDamping), error 10⁻¹⁰
/// - potential wall, η* ≤ 30: rk8pd with tolerance 10⁻¹², and `auto` with error 10⁻¹⁰
/// - potential wall, stiffer: `auto` with error 10⁻¹⁰, and extrapolated damping with half its step
/// - elastic wall: rk8pd with tolerance 10⁻¹⁰, and a method of order 6 with a step of 0.002 R/c
ReferenceAnswer reference_answer(const Scene& scene);

/// What came of one scene and one error.
struct AccuracyTrial {
  double asked_error;
  std::string status;  ///< "answered", or why not
  std::string integrator;
  double step;
  double answer;
  double estimated_error;
  double true_error;  ///< relative to the reference
  double wall_time;   ///< s
};

AccuracyTrial try_accuracy(Scene scene, double error, const ReferenceAnswer& reference);

}  // namespace impact
