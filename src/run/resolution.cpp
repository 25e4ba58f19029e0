#include "run/resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "lattice/input_error.hpp"
#include "mechanics/motion.hpp"
#include "reduced/modal_dynamics.hpp"
#include "run/expected_time.hpp"
#include "run/make_integrator.hpp"
#include "run/slow_impact.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

constexpr double kStabilityFactor = 0.96;
constexpr double kLongestStep = 0.1;         // R/c
constexpr double kReportInterval = 0.02;     // R/c, of adaptive integrators
constexpr double kRestReportInterval = 0.5;  // where a contact comes to rest
/// Where a contact comes to rest does not depend on how it came there.
constexpr double kRestTolerance = 1e-3;
/// Estimated relative error of e, extrapolated from steps of order 2, over (a v h)⁴ of the
/// shortest: without damping that of three runs as 11 of 12 disks (N = 1099, 0.05 c) keep it, the
/// others as measured on the default disk at 0.05 and 0.1 c, with damping at 0.05 c and
/// η* = 1 … 100.
struct ExtrapolationError {
  double three_runs;
  double four_runs;  ///< of which the fourth confirms the others
};
constexpr ExtrapolationError kErrorWithoutDamping{2.8e-4, 3e-5};
constexpr ExtrapolationError kErrorWithDamping{3e-5, 2e-5};
/// The same of `modal`, as measured with all points in the same scheme on 36 damped disks (a = 100
/// … 1000/R, 0.003 … 0.03 c) 10⁻⁶ to 3·10⁻⁴.
constexpr ExtrapolationError kErrorOfModes{1e-4, 5e-5};
/// The same of `imex`, times (a v)^(3/2) η*^(1/2) in units of c and R, with a v no less than 1:
/// four of five of 279 random disks have less after three runs (60 … 4000 points, a = 60 … 1500/R,
/// 0.002 … 0.1 c, η* = 3 … 1000; logarithms scatter by 2).
constexpr ExtrapolationError kErrorOfImex{0.25, 0.08};
/// The same of three runs of order 4, over (a v h)⁶ (a s)²: a wall that is hard over a spacing s
/// meets one point after another. On the default disk and on 30 points, and at a = 3000/R.
constexpr double kErrorOfOrder4 = 8e-9;
/// Of a v h, for the shortest of three steps of order 6: their errors are so small that they need
/// not be extrapolated. And the error that comparing the three then gives, over (a v h)⁶, as
/// measured on the default disk at 0.05 c.
constexpr double kLongestWayOfOrder6 = 0.6;
constexpr double kComparedError = 1e-8;

/// The steps of these runs, each over the next. Where the stability limit allows it, longer ones
/// make the first runs cheaper; but errors of order 6 grow too fast with them.
struct Coarsening {
  double least;
  double most;
};
constexpr Coarsening kCoarsening{1.12, 1.3};
constexpr Coarsening kCoarseningOfOrder6{kRefinement, kRefinement};

/// Of numerics.error: what an answer of three runs of order 2 aims at, and what others do.
constexpr double kAimUnconfirmed = 0.1;
constexpr double kAim = 0.5;

/// Whether runs are planned as if their answer were not extrapolated.
bool is_compared(IntegratorKind integrator) { return order_of(integrator) == 6; }

const Coarsening& coarsening_of(IntegratorKind integrator) {
  return is_compared(integrator) ? kCoarseningOfOrder6 : kCoarsening;
}

/// How many steps of a scale lie between these.
double places_between(double step, double longer, double base) {
  return std::log(longer / step) / std::log(base);
}

/// Methods that solve for damped velocities have a factor for their step, which runs in lanes
/// share: so their steps are taken from a scale that is the same for all scenes.
bool has_scale(IntegratorKind integrator) {
  return solves_for_damping(integrator) && traits_of(integrator).in_lanes;
}

double on_scale(IntegratorKind integrator, double step) {
  constexpr double kRounding = 1e-6;
  if (!has_scale(integrator)) return step;
  const double base = coarsening_of(integrator).least;
  return kLongestStep *
         std::pow(base, -std::ceil(places_between(step, kLongestStep, base) - kRounding));
}

/// Not by stability, which is looked at besides. Steps that solve for the bonds go with the wall,
/// unless a point, of the mass m, gets a velocity h k_a ε/m in each that counts, by the rounding ε
/// of positions. (With 0.001 v it is the energy that is off by so much; e is not.)
double longest_sensible_step(const Scene& scene, IntegratorKind integrator, const Rates& rates) {
  constexpr double kNegligible = 1e-3;
  if (!solves_for_bonds(integrator) || scene.kind != SceneKind::kCollision) return kLongestStep;
  const double of_wall = kLongestResolvedWay / scene.wall_rate();
  const double kick =
      scene.material.k_a * std::numeric_limits<double>::epsilon() * points_at(rates.spacing);
  const bool counts = of_wall * kick > kNegligible * scene.impact.approach_velocity();
  return counts ? kLongestStep : std::max(kLongestStep, of_wall);
}

/// Of a point in contact as the wall meets it, over its own: modes get some in long steps (see
/// ModalDynamics), by the stiffness 1/C under a point. C is 1.3 … 3.7/k_a on lattices of 300 and
/// 1099 points.
double inertia_of_points(const Scene& scene, IntegratorKind integrator, const Rates& rates,
                         double step) {
  constexpr double kCompliance = 2.5;
  if (integrator != IntegratorKind::kModal || rates.met) return 1.0;
  const double stiffness = scene.material.k_a * points_at(rates.spacing) / kCompliance;
  return 1.0 + ModalDynamics::kAddedInertia * step * step * stiffness;
}

double longest_step(const Scene& scene, IntegratorKind integrator, const Rates& rates) {
  constexpr int kHalvings = 30;
  const double inner_share = Motion::inner_share(scene.wall.a, rates.spacing);
  const double gain = solves_for_bonds(integrator) ? rate_of_gain(scene, rates) : 0.0;
  const auto is_stable = [&](double step) {
    const double rate = contact_rate(scene, rates, integrator, step) /
                            inertia_of_points(scene, integrator, rates, step) +
                        gain;
    return step <= kStabilityFactor * step_limit(integrator, rates.lattice, rate, inner_share);
  };
  const double longest = longest_sensible_step(scene, integrator, rates);
  double stable = 0.0;
  for (int k = 1; k < kHalvings; ++k) {
    const double part = std::ldexp(longest, -k);
    if (is_stable(stable + part)) stable += part;
  }
  return stable;
}

ExtrapolationError error_of_imex(const Scene& scene) {
  const double frequency = std::sqrt(scene.material.k_a);
  const double rate = std::max(1.0, scene.wall_rate() / frequency);
  const double per_fit = std::pow(rate, -1.5) / std::sqrt(scene.material.eta / frequency);
  return {per_fit * kErrorOfImex.three_runs, per_fit * kErrorOfImex.four_runs};
}

/// The way that gives the wanted error of an answer extrapolated from so many runs.
double way_of_error(const Scene& scene, IntegratorKind integrator, int runs, double spacing) {
  const double error = scene.numerics.error;
  if (order_of(integrator) == 4) {
    const double hardness = scene.wall.a * spacing;
    return std::pow(kAimUnconfirmed * error / (kErrorOfOrder4 * hardness * hardness), 1.0 / 6.0);
  }
  const ExtrapolationError of = integrator == IntegratorKind::kModal  ? kErrorOfModes
                                : integrator == IntegratorKind::kImex ? error_of_imex(scene)
                                : scene.is_damped()                   ? kErrorWithDamping
                                                                      : kErrorWithoutDamping;
  return runs > 3 ? std::pow(kAim * error / of.four_runs, 1.0 / 4.0)
                  : std::pow(kAimUnconfirmed * error / of.three_runs, 1.0 / 4.0);
}

/// Of the shortest of so many steps, in ranges of the wall.
double longest_way(const Scene& scene, IntegratorKind integrator, int runs, double spacing) {
  if (is_compared(integrator)) {
    return std::min(kLongestWayOfOrder6,
                    std::pow(kAim * scene.numerics.error / kComparedError, 1.0 / 6.0));
  }
  return std::min(way_of_error(scene, integrator, runs, spacing),
                  kLongestResolvedWay / std::pow(kCoarsening.least, runs - 1));
}

/// The last of so many runs of an answer, as it is likely to be needed.
Resolution last_of(int runs, const Scene& scene, IntegratorKind integrator, const Rates& rates) {
  const int leading = runs - 1;
  const Coarsening& by = coarsening_of(integrator);
  const double wall_rate = scene.wall_rate();
  double longest = longest_step(scene, integrator, rates);
  const double step = dividing_resets(
      scene, on_scale(integrator,
                      std::min(longest / std::pow(by.least, leading),
                               longest_way(scene, integrator, runs, rates.spacing) / wall_rate)));
  if (!is_compared(integrator)) longest = std::min(longest, kLongestResolvedWay / wall_rate);
  double coarsening = std::min(by.most, std::pow(longest / step, 1.0 / leading));
  if (has_scale(integrator)) {
    coarsening = std::pow(by.least, std::floor(places_between(1.0, coarsening, by.least)));
  }
  return {integrator, step, 0.0, 0.0, leading, coarsening};
}

/// Of all runs of an answer, over a time of 1 R/c.
double cost_of(const Scene& scene, const Resolution& last, const Rates& rates) {
  const double spacing = rates.spacing;
  return steps_of_all_runs(last) * cost_of_step(scene, last.integrator, spacing) / last.step +
         (last.leading_runs + 1) * cost_of_factor(scene, last.integrator, spacing) / rates.time;
}

Resolution fixed_resolution(const Scene& scene, IntegratorKind integrator, const Rates& rates) {
  if (scene.kind != SceneKind::kCollision) {
    return {integrator, dividing_resets(scene, longest_step(scene, integrator, rates))};
  }
  const Resolution of_three = last_of(3, scene, integrator, rates);
  if (order_of(integrator) != 2) return of_three;
  const Resolution of_four = last_of(4, scene, integrator, rates);
  return cost_of(scene, of_four, rates) < cost_of(scene, of_three, rates) ? of_four : of_three;
}

/// Whether `auto` may.
bool may_take(const IntegratorTraits& method, const Scene& scene, const Rates& rates) {
  if (method.kind == IntegratorKind::kModal) {
    return rates.modal && may_be_modal(scene, std::lround(points_at(rates.spacing)));
  }
  return is_automatic(method, scene.circumstances()) && (rates.imex || !method.implicit_bonds);
}

Resolution automatic_resolution(const Scene& scene, const Rates& rates) {
  std::vector<Resolution> choice;
  for (const auto& method : kIntegrators) {
    if (!may_take(method, scene, rates)) continue;
    choice.push_back(fixed_resolution(scene, method.kind, rates));
  }
  return *std::min_element(choice.begin(), choice.end(), [&](const auto& a, const auto& b) {
    return cost_of(scene, a, rates) < cost_of(scene, b, rates);
  });
}

/// Of a method that only the wall sets a limit to.
double given_step_of_wall(const Scene& scene) {
  const double step = *scene.numerics.step;
  const double limit = kLongestResolvedWay / (scene.wall.a * scene.impact.normal_velocity());
  if (step <= limit) return step;
  throw InputError(
      fmt::format("numerics.step: got {}, allowed: at most {:.4g} R/c with {}, in which the disk "
                  "comes half the "
                  "range of the wall",
                  step, limit, name_of(scene.numerics.integrator)));
}

double given_step(const Scene& scene, IntegratorKind integrator, const Spectrum& lattice) {
  if (solves_for_bonds(integrator) && scene.kind == SceneKind::kCollision) {
    return given_step_of_wall(scene);
  }
  const double step = *scene.numerics.step;
  const double limit = step_limit(integrator, lattice);
  if (step <= limit) return step;
  throw InputError(fmt::format(
      "numerics.step: got {}, allowed: at most {:.4g} R/c, the stability limit of {} on this "
      "lattice with this damping",
      step, limit, name_of(integrator)));
}

/// Over that at N = 1099: as measured up to N = 40 000, where factors outgrow the caches.
double growth_of_solutions(double spacing, double power) {
  return std::pow(points_at(spacing) / 1099.0, power);
}

/// Of the time of a step over that of velocity Verlet: with the number of points.
double power_of_step(IntegratorKind integrator) {
  if (integrator == IntegratorKind::kModal) return -0.5;
  return solves_for_bonds(integrator) ? 0.3 : 0.0;
}

/// The same of a factor.
double power_of_factor(IntegratorKind integrator) {
  return integrator == IntegratorKind::kImex ? 0.2 : 0.0;
}

}  // namespace

double dividing_resets(const Scene& scene, double step) {
  if (!has_resets(scene)) return step;
  constexpr double kRounding = 1e-9;
  return scene.wall.reset_interval / std::ceil(scene.wall.reset_interval / step - kRounding);
}

double cost_of_step(const Scene& scene, IntegratorKind integrator, double spacing) {
  const IntegratorTraits& method = traits_of(integrator);
  const double growth = growth_of_solutions(spacing, power_of_step(integrator));
  return growth * (scene.is_damped() ? method.damped_cost : method.cost);
}

double cost_of_factor(const Scene& scene, IntegratorKind integrator, double spacing) {
  if (!scene.is_damped()) return 0.0;
  const double growth = growth_of_solutions(spacing, power_of_factor(integrator));
  return growth * traits_of(integrator).factor_cost;
}

IntegratorKind with_given_step(IntegratorKind integrator) {
  return integrator == IntegratorKind::kAuto ? IntegratorKind::kVerlet : integrator;
}

Resolution first_resolution(const Scene& scene, const Rates& rates) {
  const IntegratorKind integrator = scene.numerics.integrator;
  if (integrator == IntegratorKind::kReduced) {
    return scene.numerics.step ? Resolution{integrator, given_step_of_wall(scene)}
                               : reduced_resolution(scene);
  }
  if (is_adaptive(integrator)) {
    const bool comes_to_rest = scene.kind == SceneKind::kContact;
    const double tolerance = comes_to_rest ? kRestTolerance : scene.numerics.error;
    return {integrator,
            dividing_resets(scene, comes_to_rest ? kRestReportInterval : kReportInterval),
            scene.numerics.tolerance.value_or(tolerance)};
  }
  if (scene.numerics.step) {
    const IntegratorKind used = with_given_step(integrator);
    return {used, dividing_resets(scene, given_step(scene, used, rates.lattice))};
  }
  return integrator == IntegratorKind::kAuto ? automatic_resolution(scene, rates)
                                             : fixed_resolution(scene, integrator, rates);
}

std::optional<Resolution> better_integrator(const Scene& scene, const Resolution& resolution,
                                            double step, const Rates& rates) {
  if (scene.numerics.integrator != IntegratorKind::kAuto) return std::nullopt;
  std::optional<Resolution> better;
  double least_cost = cost_of_step(scene, resolution.integrator, rates.spacing) / step;
  for (const IntegratorTraits& method : kIntegrators) {
    if (!may_take(method, scene, rates)) continue;
    const bool is_present = method.kind == resolution.integrator;
    const bool is_higher = method.order > order_of(resolution.integrator);
    if (is_present || !(is_higher || solves_for_bonds(resolution.integrator))) continue;
    Resolution first = fixed_resolution(scene, method.kind, rates);
    first.lift = resolution.lift;
    const double cost = cost_of(scene, first, rates);
    if (!(cost <= least_cost)) continue;
    least_cost = cost;
    better = first;
  }
  return better;
}

double steps_of_all_runs(const Resolution& last) {
  double steps = 1.0;
  for (int k = 1; k <= last.leading_runs; ++k) steps += std::pow(last.coarsening, -k);
  return steps;
}

std::vector<Resolution> leading_up_to(const Scene& scene, const Resolution& finest) {
  std::vector<Resolution> runs{finest};
  for (int k = 0; k < finest.leading_runs; ++k) {
    Resolution coarser = runs.back();
    if (is_adaptive(finest.integrator)) {
      coarser.tolerance *= std::pow(finest.coarsening, kToleranceOrder);
    } else {
      coarser.step = on_scale(finest.integrator, coarser.step * finest.coarsening);
    }
    runs.push_back(coarser);
  }
  if (is_adaptive(finest.integrator) || !has_resets(scene)) return runs;
  runs.back().step = dividing_resets(scene, runs.back().step);
  for (auto run = runs.rbegin() + 1; run != runs.rend(); ++run) {
    *run = finer(scene, run[-1], kRefinement);
  }
  const auto second = runs.end() - 2;
  if (in_half_steps(second[1], second[0])) runs.erase(runs.begin(), second);
  return runs;
}

bool in_half_steps(const Resolution& coarse, const Resolution& fine) {
  constexpr double kRounding = 1e-9;
  return fine.step <= 0.5 * (1.0 + kRounding) * coarse.step;
}

Resolution finer(const Scene& scene, const Resolution& resolution, double factor) {
  Resolution next = resolution;
  if (is_adaptive(resolution.integrator)) {
    next.tolerance /= std::pow(factor, kToleranceOrder);
  } else {
    next.step = dividing_resets(scene, on_scale(resolution.integrator, resolution.step / factor));
  }
  return next;
}

double output_interval(const Scene& scene, double step) {
  return step * std::max(1.0, std::round(scene.output.period / step));
}

}  // namespace impact
