#include "run/forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "run/expected_time.hpp"
#include "run/resolution.hpp"
#include "run/slow_impact.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

/// Of a step of undamped velocity Verlet, as test/bench/bench_runs.cpp measures it (s): so much in
/// any case, and so much a point, between 5·10⁻⁹ in the caches and 14·10⁻⁹ outside.
constexpr double kStep = 3e-7;
constexpr double kStepOfPoint = 8e-9;

/// After a collision the disk is followed for about so long, times R/c_s: see SeparationEnd.
constexpr double kFlight = 2.0;

/// Largest eigenvalues of random lattices for k_a = m = 1 and η = m = 1.
constexpr double kOmegaSquared = 8.0;
constexpr double kGamma = 12.5;

/// An adaptive method takes steps of this over the highest frequency (rk8pd).
constexpr double kAdaptiveStep = 3.0;
/// If it is stiff, its steps are those in which the force of the wall changes: they cost so much a
/// radian of the disk's swinging on the wall, besides the reports (bdf).
constexpr double kCostOfRadian = 240.0;

/// The part of expected_time() after which a contact was at rest, for P = 2·10⁻⁴ … 10⁻².
constexpr double kPartOfRelaxation = 0.25;

/// An iteration of Newton's method: time (s) = this · N^kPowerOfIteration.
constexpr double kIterations = 12.0;
constexpr double kIterationsOfRolling = 1000.0;  // with the search for other places of rest
constexpr double kIteration = 2.5e-7;
constexpr double kPowerOfIteration = 1.22;

Forecast of_static_solution(const Scene& scene, Eigen::Index points) {
  const bool rolls = scene.kind == SceneKind::kContact && !scene.load.hold_rotation;
  const double iterations = rolls ? kIterationsOfRolling : kIterations;
  const double of_iteration = kIteration * std::pow(static_cast<double>(points), kPowerOfIteration);
  return {iterations, iterations * of_iteration};
}

Spectrum typical_spectrum(const Scene& scene, double points) {
  return {kOmegaSquared * scene.material.k_a * points, kGamma * scene.material.eta};
}

/// Steps of a run, and the time of one in steps of undamped velocity Verlet.
struct Work {
  double steps = 0.0;  ///< of all runs
  double cost_of_step = 0.0;
  double cost_of_factors = 0.0;  ///< of all runs, in the same steps
};

/// The rate at which the wall's force changes: the disk swings on it, or meets it at its speed and
/// rings.
double rate_of_wall_force(const Scene& scene) {
  if (scene.kind == SceneKind::kContact) return std::sqrt(scene.wall.a * scene.load.p);
  return scene.wall_rate() + estimated_sound_speed(scene.material.k_a);
}

/// The steps of all runs over those of the last one, which this is.
double all_runs(const Scene& scene, const Resolution& last) {
  const bool is_controlled = scene.kind == SceneKind::kCollision && !scene.numerics.are_given();
  return is_controlled ? steps_of_all_runs(last) : 1.0;
}

Work work_of(const Scene& scene, const Rates& rates, Eigen::Index points, double time) {
  const IntegratorKind integrator = scene.numerics.integrator;
  const bool stiff = traits_of(integrator).stiff;
  if (is_adaptive(integrator) && !stiff) {
    const double fastest =
        std::sqrt(rates.lattice.omega_squared + rates.wall) + rates.lattice.gamma;
    return {all_runs(scene, Resolution()) * time * fastest / kAdaptiveStep,
            cost_of_step(scene, integrator, rates.spacing)};
  }
  const Resolution resolution =
      scene.numerics.step
          ? Resolution{with_given_step(integrator), dividing_resets(scene, *scene.numerics.step)}
      : may_be_reduced(scene, points) ? reduced_resolution(scene)
                                      : first_resolution(scene, rates);
  double cost = cost_of_step(scene, resolution.integrator, rates.spacing);
  if (is_adaptive(integrator)) {
    cost += kCostOfRadian * resolution.step * rate_of_wall_force(scene);
  }
  return {
      all_runs(scene, resolution) * time / resolution.step, cost,
      (resolution.leading_runs + 1) * cost_of_factor(scene, resolution.integrator, rates.spacing)};
}

Eigen::Index points_of(const Scene& scene) {
  if (scene.kind != SceneKind::kStretch) return scene.disk.recipe.points;
  constexpr double kMost = 1e6;  // a rectangle of more is refused by make_bodies()
  const double area = scene.stretch.width * scene.stretch.height;
  return static_cast<Eigen::Index>(std::min(kMost, scene.disk.recipe.points * area / M_PI));
}

Eigen::Index other_points_of(const Scene& scene) {
  if (scene.has_elastic_wall()) return scene.wall.points;
  if (!scene.hits_disk()) return 0;
  const int points = scene.disk.recipe.points;
  return Eigen::Index{scene.wall.disks} * scene.points_of_row_disk(points).value_or(points);
}

/// The keys whose defaults would at least halve the time, those that would most first.
std::vector<std::string> causes(const Scene& scene, Eigen::Index points, Eigen::Index other_points,
                                double seconds) {
  constexpr std::size_t kMost = 3;
  std::vector<std::pair<double, std::string>> found;
  for (const Parameter<Scene>& parameter : scene_parameters()) {
    const bool is_the_question = parameter.key == "scene" || parameter.key == "wall.type";
    if (!parameter.applies(scene) || is_the_question) continue;
    Scene other = scene;
    parameter.read(other, parameter.write(Scene{}));
    const double time = other.has_recipes_only() ? forecast(other).seconds
                                                 : forecast(other, points, other_points).seconds;
    if (time < 0.5 * seconds) found.emplace_back(time, parameter.key);
  }
  std::sort(found.begin(), found.end());
  std::vector<std::string> keys;
  for (const auto& cause : found) {
    if (keys.size() < kMost) keys.push_back(cause.second);
  }
  return keys;
}

}  // namespace

Forecast forecast(const Scene& scene) {
  return forecast(scene, points_of(scene), other_points_of(scene));
}

Forecast forecast(const Scene& scene, Eigen::Index points, Eigen::Index other_points) {
  if (scene.is_static()) return of_static_solution(scene, points);
  const auto number = static_cast<double>(points);
  const PotentialWall wall = repulsion(scene, points);
  Rates expected = rates(scene, typical_spectrum(scene, number), wall, static_cast<int>(points),
                         estimated_sound_speed(scene.material.k_a));
  const double gap = wall.gap_of_energy(negligible_wall_energy(scene));
  double time = expected_time(scene, points, gap_at_start(scene, gap), gap);
  expected.time = time;
  if (scene.kind == SceneKind::kCollision) {
    time += kFlight / expected.sound_speed;
  } else {
    time *= kPartOfRelaxation;
  }
  const Work work = work_of(scene, expected, points, time);
  const double of_step = kStep + kStepOfPoint * static_cast<double>(points + other_points);
  return {work.steps, (work.steps * work.cost_of_step + work.cost_of_factors) * of_step};
}

std::string text(const Forecast& forecast) {
  return fmt::format("{:.2g} steps and {} on one processor", forecast.steps,
                     text_of_time(forecast.seconds));
}

std::string text_of_time(double seconds) {
  constexpr double kMinute = 60.0;
  constexpr double kHour = 3600.0;
  constexpr double kMany = 99.5;  // of a unit: the next one is shown
  if (seconds < kMany) return fmt::format("{:.2g} s", seconds);
  if (seconds < kMany * kMinute) return fmt::format("{:.2g} min", seconds / kMinute);
  return fmt::format("{:.2g} h", seconds / kHour);
}

void refuse_if_too_long(const Scene& scene) {
  refuse_if_too_long(scene, points_of(scene), other_points_of(scene));
}

void refuse_if_too_long(const Scene& scene, Eigen::Index points, Eigen::Index other_points) {
  const Forecast expected = forecast(scene, points, other_points);
  if (expected.seconds <= scene.numerics.longest) return;
  const std::vector<std::string> keys = causes(scene, points, other_points, expected.seconds);
  throw InputError(fmt::format(
      "numerics.longest: this scene would take about {}{}, allowed: at most {} s", text(expected),
      keys.empty() ? "" : fmt::format(" ({})", fmt::join(keys, ", ")), scene.numerics.longest));
}

}  // namespace impact
