#pragma once

#include <cstdint>
#include <string>

#include "scene/scene.hpp"

namespace impact {

struct RandomScene {
  Scene scene;
  int rejected = 0;  ///< drawn before it and not of sensible size
};

/// The scene of this number from the random scenes of a seed: of five in turn one contact, one
/// collision with an elastic wall and three with the potential wall. Drawn anew until it is of
/// sensible size. Drawn log-uniformly, to six digits, are
///   N 3 … 3000, a 30 … 10⁴/R, numerics.error 10⁻⁹ … 10⁻², v 10⁻⁴ … 0.3 c or P 10⁻¹⁰ … 0.3 M c²/R;
///   in half of the scenes each k_a (10⁻³ … 10³ M c²/R², else 1), k_b (10⁻³ … 10³ M c²/R⁴, else 0),
///   V₀ (10⁻³ … 10³ times its default, else auto), in half of the collisions η* (10⁻² … 10³, else
///   0) and the gap (0.01 … 1 R, else auto);
///   of elastic walls 20 … 3000 points, the threshold (0.02 … 2 R), the time between resets
///   (10⁻³ … 0.1 R/c) and in half of them each the width (0.5 … 10 R, else auto) and the height
///   (0.3 … 4 R, else auto).
/// Placement, rim, the lattice's seed, an elastic wall's boundary and gap measure are drawn evenly.
RandomScene random_scene(std::uint64_t seed, int number);

/// The same for slow impacts on the potential wall, of which `auto` tries the methods `reduced`,
/// `modal` and `imex`: disk, numerics.error, V₀ and η* as there, a 30 … 3·10³/R, v 10⁻⁵ … 0.006
/// √(k_a R²/M); drawn anew until `auto` does, and work_of() is at most 1.5·10⁷.
RandomScene random_slow_scene(std::uint64_t seed, int number);

/// Whether a scene of a lattice that can be made is of sensible size: v at most 0.3 √(k_a R²/M) and
/// P at most 0.3 k_a R, so that the disk is not crushed; of a contact an error in the strain,
/// numerics.error P/(k_a R), that doubles can hold, 10⁻¹⁵ R; less energy in the wall than in the
/// motion at the start, and of a point where it comes into reach of an elastic wall; work_of() at
/// most 5·10⁶.
bool is_sensible(const Scene& scene);

/// On the potential wall damping counts as stiff where its fastest decay γ exceeds the fastest
/// vibration ω, with the wall at its stiffest, by this factor: there implicit methods cost less
/// than explicit ones.
constexpr double kStiffDamping = 100.0;

/// Forecast of the work of one run: points times the expected time in units of 1/(ω + γ), with the
/// wall at its stiffest and no more than stiff damping.
/// @throw InputError as compose().
double work_of(const Scene& scene);

/// The command that computes the answer of a scene without files of its own.
std::string impact_command(const Scene& scene);

/// "contact", "potential wall" or "elastic wall".
std::string kind_of(const Scene& scene);

}  // namespace impact
