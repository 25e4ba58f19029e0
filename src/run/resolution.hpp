#pragma once

#include <memory>
#include <optional>

#include "mechanics/integrator.hpp"
#include "mechanics/spectrum.hpp"
#include "mechanics/wall_contact.hpp"
#include "scene/scene.hpp"

namespace impact {

/// How finely time is resolved.
struct Resolution {
  IntegratorKind integrator = IntegratorKind::kVerlet;
  double step = 1.0;       ///< R/c; of an adaptive integrator: the interval at which it reports
  double tolerance = 0.0;  ///< of an adaptive integrator
};

inline bool operator==(const Resolution& a, const Resolution& b) {
  return a.integrator == b.integrator && a.step == b.step && a.tolerance == b.tolerance;
}

/// What a resolution is chosen by, besides the scene.
struct Rates {
  Spectrum lattice;
  double wall = 0.0;  ///< square of the frequency that the wall adds at its stiffest, c²/R²
  double sound_speed = 1.0;  ///< c
};

/// Estimate of the largest wall force on one point (M c²/R) during the run, for the choice of the
/// step. Total force: that of a harmonic impact of duration τ = π (R/c_s) √ln(4c_s/v), or twice
/// the load. Its share on one point: twice the greatest pressure of the 2D Hertz contact,
/// p₀ = 2P/(π a_c) with a_c² = 4PR/(πE) (K. L. Johnson, Contact Mechanics, 1985, eqs. 4.43–4.45),
/// times the point spacing √(π/N) R, and at most the whole; but no less than the force a m v²/2
/// that stops a single point.
double largest_point_force(const Scene& scene, int points, double sound_speed);

/// The rates of a scene on this wall. Two points that push each other, one of them of an elastic
/// wall, move like one of half the mass.
Rates rates(const Scene& scene, const Spectrum& lattice, const WallContact& wall, int points,
            double sound_speed);

/// Largest stable step of a method of fixed step (R/c).
double step_limit(IntegratorKind integrator, double omega_squared, double gamma);

/// The longest step (R/c), not above `step`, that divides the interval between resets, if there are
/// resets.
double dividing_resets(const Scene& scene, double step);

/// Time of a step of a method of fixed step, in steps of undamped velocity Verlet, as
/// test/bench/bench_runs.cpp measures it at N = 1099.
double cost_of_step(const Scene& scene, IntegratorKind integrator);

/// Order of a method of fixed step.
int order_of(IntegratorKind integrator);

/// The resolution that the scene gives or, where it leaves it open, the one to begin with.
///
/// `integrator: auto` in a scene of motion: of the methods that the scene can have (without damping
/// velocity Verlet and Blanes–Moan; with damping velocity Verlet, implicit and extrapolated
/// damping) the one of least cost, force evaluations and linear solutions counted, at the step that
/// is likely to give the wanted error. That is for methods of order 2, by the error 2·10⁻⁴ (a v h)²
/// of e that was measured on impacts on the potential wall, √(ε/(4·10⁻⁴))/(a v), and for all at
/// most 1/1.3 of the longest, which is 0.96 of the stability limit, the wall at its expected
/// stiffest counted, and 0.1 R/c at most. It is a multiple or a whole part of 0.02 R/c, so that the
/// usual output periods are multiples of it.
///
/// `step: auto` begins with a step 1.31 times longer, to compare with.
///
/// Where velocities are reset at intervals, the step, given or not, is shortened to divide them.
/// @throw InputError when a given step exceeds the stability limit of the lattice and its damping.
Resolution first_resolution(const Scene& scene, const Rates& rates);

/// The method of order 6 to begin anew with, where `auto` chose one of order 2 which turns out to
/// need this step (R/c), and the other costs less.
std::optional<Resolution> better_integrator(const Scene& scene, const Resolution& resolution,
                                            double step, const Rates& rates);

/// The next finer resolution of the same integrator: its step shorter by this factor at least, or
/// its tolerance smaller by `factor` to the power of 4.
Resolution finer(const Scene& scene, const Resolution& resolution, double factor);

/// The longest step not above `value` (R/c) that is a multiple of 0.02 R/c, at least `unit`, or a
/// whole part of `unit`.
double round_step_down(double value, double unit);

/// Makes an integrator of fixed step, for one run or for lanes.
template <class Field>
std::unique_ptr<FixedStepIntegrator<Field>> make_fixed(IntegratorKind integrator);

/// Makes the integrator of a resolution.
/// @throw InputError for rk8pd in a program that does not offer it, see offer_rk8pd().
std::unique_ptr<Integrator> make_integrator(const Scene& scene, const Resolution& resolution,
                                            double sound_speed);

}  // namespace impact
