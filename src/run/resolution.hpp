#pragma once

#include <optional>
#include <vector>

#include "run/rates.hpp"
#include "scene/scene.hpp"

namespace impact {

/// The steps of successive runs of an answer are shorter by this factor at least, unless planned.
constexpr double kRefinement = 1.2;

/// How finely time is resolved.
struct Resolution {
  IntegratorKind integrator = IntegratorKind::kVerlet;
  double step = 1.0;       ///< R/c; of an adaptive integrator: the interval at which it reports
  double tolerance = 0.0;  ///< of an adaptive integrator
  double lift = 0.0;       ///< R, how much higher than in the composition a collision starts
  int leading_runs = 2;    ///< that come before it where it is the last one of an answer, …
  double coarsening = kRefinement;  ///< … each with a step so many times that of the next
};

/// Whether they make the same run.
inline bool operator==(const Resolution& a, const Resolution& b) {
  return a.integrator == b.integrator && a.step == b.step && a.tolerance == b.tolerance &&
         a.lift == b.lift;
}

/// The longest step (R/c), not above `step`, that divides the interval between resets, if there are
/// resets.
double dividing_resets(const Scene& scene, double step);

/// The method in use where the scene gives a step: `auto` stands for velocity Verlet.
IntegratorKind with_given_step(IntegratorKind integrator);

/// IntegratorTraits::cost for the forces of the scene on a lattice of this spacing (R): solutions
/// for bonds grow faster than N.
double cost_of_step(const Scene& scene, IntegratorKind integrator, double spacing);
/// IntegratorTraits::factor_cost, once a run.
double cost_of_factor(const Scene& scene, IntegratorKind integrator, double spacing);

/// Tolerances go with this power of the factor by which steps would be shortened.
constexpr int kToleranceOrder = 4;
/// Of a v h: the step up to which methods show their order.
constexpr double kLongestResolvedWay = 0.5;
/// Steps of all runs of an answer over those of the last one, which this is.
double steps_of_all_runs(const Resolution& last);

/// The resolution that the scene gives or, where it leaves it open, the one that is likely to be
/// needed.
///
/// Where the integrator is `reduced`, as reduced_resolution(). Of other motion:
///
/// `integrator: auto` in a scene of motion: of the methods that the scene can have (without damping
/// velocity Verlet, Takahashi–Imada on the potential wall and Blanes–Moan; with damping velocity
/// Verlet, implicit and extrapolated damping) the one of least cost, force evaluations and linear
/// solutions counted, at the step that is likely to give the wanted error. In a collision two or
/// three more runs come before, each with a step 1.12 to 1.3 times that of the next (1.2 times for
/// order 6). The longest is at most 0.96 of the stability limit, the wall at its expected stiffest
/// counted, and 0.1 R/c. For methods of order 2 and 4 it is at most 0.5/(a v), so that the runs
/// show their order, and the error of the extrapolated e, as it is estimated, is some 10⁻⁴ (a v h)⁴
/// or 10⁻⁶ (a v h)⁶ of the shortest (the coefficients stand with the code). Three runs aim at a
/// tenth of numerics.error, since above that a fourth one has to confirm them; four, of order 2, at
/// half of it; the cheaper plan is taken. For methods of order 6 the shortest step is at most
/// 0.6/(a v), and three runs compared give an error of 10⁻⁸ (a v h)⁶, half of numerics.error.
///
/// Where velocities are reset at intervals, the step, given or not, is shortened to divide them.
/// @throw InputError when a given step exceeds the stability limit of the lattice and its damping
/// or, with `reduced`, `imex` and `modal`, 0.5/(a v).
Resolution first_resolution(const Scene& scene, const Rates& rates);

/// The runs of a collision that end with this one: it, and those before it, the first one last. Two
/// where velocities are reset so often that the first step which divides their interval is followed
/// by its half.
std::vector<Resolution> leading_up_to(const Scene& scene, const Resolution& finest);

/// Whether the second has at most half the steps of the first.
bool in_half_steps(const Resolution& coarse, const Resolution& fine);

/// The method of higher order or, in the place of `imex` and `modal`, of any order to begin anew
/// with, where `auto` chose one which turns out to need this step (R/c), and the other costs less.
std::optional<Resolution> better_integrator(const Scene& scene, const Resolution& resolution,
                                            double step, const Rates& rates);

/// The next finer resolution of the same integrator: its step shorter by this factor at least, or
/// its tolerance smaller by its power of kToleranceOrder.
Resolution finer(const Scene& scene, const Resolution& resolution, double factor);

/// Time between the states that a run gives out (R/c): the whole number of steps, at least one,
/// that is nearest to output.period.
double output_interval(const Scene& scene, double step);

}  // namespace impact
