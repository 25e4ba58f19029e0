#include "run/step_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "lattice/input_error.hpp"
#include "mechanics/velocity_verlet.hpp"

namespace impact {
namespace {

constexpr double kAccuracyFactor = 0.5;
constexpr double kStabilityFactor = 0.9;
constexpr double kLargestStep = 0.02;  // R/c

/// Two points that push each other apart move against each other like one of half the mass.
constexpr double kBothEndsMove = 2.0;

double automatic_step(const Scene& scene, const Spectrum& spectrum, const WallContact& wall,
                      int points, double sound_speed) {
  const double ends = scene.wall.kind == WallKind::kLattice ? kBothEndsMove : 1.0;
  const double stiffness = wall.stiffness(largest_point_force(scene, points, sound_speed));
  const double omega_squared = spectrum.omega_squared + ends * stiffness * points;
  const double step =
      std::min(kAccuracyFactor * 2.0 / std::sqrt(omega_squared),
               kStabilityFactor * VelocityVerlet().step_limit(omega_squared, spectrum.gamma));
  return round_down_to_125(std::min(step, kLargestStep));
}

}  // namespace

double largest_point_force(const Scene& scene, int points, double sound_speed) {
  double total = 2.0 * scene.load.p;
  if (scene.kind == SceneKind::kCollision) {
    const double v = scene.impact.velocity;
    total = v * sound_speed / std::sqrt(std::max(1.0, std::log(4.0 * sound_speed / v)));
  }
  const double young_modulus = sound_speed * sound_speed / M_PI;
  const double stopping_one_point =
      scene.kind == SceneKind::kCollision
          ? 0.5 * scene.wall.a * scene.impact.velocity * scene.impact.velocity / points
          : 0.0;
  const double half_width = std::sqrt(4.0 * total / (M_PI * young_modulus));
  const double peak_pressure = 2.0 * total / (M_PI * half_width);
  const double share = std::min(total, 2.0 * peak_pressure * std::sqrt(M_PI / points));
  return std::max(share, stopping_one_point);
}

namespace {

/// The longest step, not above `step`, that divides the interval between resets.
double dividing_resets(const Scene& scene, double step) {
  if (scene.wall.kind != WallKind::kLattice || scene.wall.boundary != Boundary::kReset) return step;
  constexpr double kRounding = 1e-9;
  return scene.wall.reset_interval / std::ceil(scene.wall.reset_interval / step - kRounding);
}

double given_step(const Scene& scene, const Spectrum& spectrum) {
  const double limit = VelocityVerlet().step_limit(spectrum.omega_squared, spectrum.gamma);
  if (*scene.numerics.step > limit) {
    throw InputError(fmt::format(
        "numerics.step: got {}, allowed: at most {:.4g} R/c, the stability limit of velocity "
        "Verlet on this lattice with this damping",
        *scene.numerics.step, limit));
  }
  return *scene.numerics.step;
}

}  // namespace

double choose_step(const Scene& scene, const Spectrum& spectrum, const WallContact& wall,
                   int points, double sound_speed) {
  return dividing_resets(scene, scene.numerics.step
                                    ? given_step(scene, spectrum)
                                    : automatic_step(scene, spectrum, wall, points, sound_speed));
}

double round_down_to_125(double value) {
  const auto exponent = static_cast<int>(std::floor(std::log10(value)));
  double best = std::stod(fmt::format("5e{}", exponent - 1));
  for (const int digit : {1, 2, 5}) {
    const double candidate = std::stod(fmt::format("{}e{}", digit, exponent));
    if (candidate <= value) best = candidate;
  }
  return best;
}

}  // namespace impact
