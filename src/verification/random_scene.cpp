#include "verification/random_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "run/compose.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

constexpr double kMostWorkOfScene = 5e6;
constexpr double kMostWorkOfSlowScene = 1.5e7;
constexpr double kLargestStrain = 0.3;
constexpr double kStrainRounding = 1e-15;  // R, of a strain

class Draw {
 public:
  Draw(std::uint64_t seed, int number) {
    std::seed_seq sequence{seed, seed >> 32U, static_cast<std::uint64_t>(number)};
    random_.seed(sequence);
  }

  int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }
  bool coin() { return below(2) == 0; }
  double log_uniform(double low, double high) {
    const double part = std::uniform_real_distribution<double>(0.0, 1.0)(random_);
    return std::stod(fmt::format("{:.6g}", low * std::pow(high / low, part)));
  }
  double log_uniform_or(double other, double low, double high) {
    return coin() ? log_uniform(low, high) : other;
  }
  std::optional<double> log_uniform_or_none(double low, double high) {
    if (coin()) return log_uniform(low, high);
    return std::nullopt;
  }
  int whole(double low, double high) {
    return static_cast<int>(std::lround(log_uniform(low, high)));
  }

 private:
  std::mt19937_64 random_;
};

void draw_disk(Draw& draw, Scene& scene) {
  scene.seed = 1U + static_cast<std::uint64_t>(draw.below(1000000));
  scene.disk.recipe.points = draw.whole(3.0, 3000.0);
  scene.disk.recipe.placement = draw.coin() ? Placement::kUniform : Placement::kBlueNoise;
  scene.disk.recipe.rim = draw.coin();
  scene.material.k_a = draw.log_uniform_or(1.0, 1e-3, 1e3);
  scene.material.k_b = draw.log_uniform_or(0.0, 1e-3, 1e3);
}

void draw_wall(Draw& draw, Scene& scene) {
  scene.wall.a = draw.log_uniform(30.0, 1e4);
  const double v0 = scene.wall.a / scene.disk.recipe.points;
  scene.wall.v0 = draw.log_uniform_or_none(1e-3 * v0, 1e3 * v0);
}

void draw_elastic_wall(Draw& draw, Scene& scene) {
  scene.wall.kind = WallKind::kLattice;
  scene.wall.points = draw.whole(20.0, 3000.0);
  scene.wall.width = draw.log_uniform_or_none(0.5, 10.0);
  scene.wall.height = draw.log_uniform_or_none(0.3, 4.0);
  scene.wall.threshold = draw.log_uniform(0.02, 2.0);
  scene.wall.gap = draw.coin() ? GapMeasure::kNormal : GapMeasure::kVertical;
  scene.wall.boundary = static_cast<Boundary>(draw.below(3));
  scene.wall.reset_interval = draw.log_uniform(1e-3, 0.1);
}

Scene draw_scene(Draw& draw, int kind) {
  Scene scene;
  draw_disk(draw, scene);
  draw_wall(draw, scene);
  scene.numerics.error = draw.log_uniform(1e-9, 1e-2);
  if (kind == 0) {
    scene.kind = SceneKind::kContact;
    scene.load.p = draw.log_uniform(1e-10, 0.3);
    return scene;
  }
  if (kind == 1) draw_elastic_wall(draw, scene);
  scene.material.eta = draw.log_uniform_or(0.0, 1e-2, 1e3);
  scene.impact.velocity = draw.log_uniform(1e-4, 0.3);
  scene.impact.gap = draw.log_uniform_or_none(0.01, 1.0);
  return scene;
}

Scene draw_slow_scene(Draw& draw) {
  Scene scene;
  draw_disk(draw, scene);
  scene.wall.a = draw.log_uniform(30.0, 3e3);
  const double v0 = scene.wall.a / scene.disk.recipe.points;
  scene.wall.v0 = draw.log_uniform_or_none(1e-3 * v0, 1e3 * v0);
  scene.numerics.error = draw.log_uniform(1e-9, 1e-2);
  scene.impact.velocity = draw.log_uniform(1e-5, 6e-3) * std::sqrt(scene.material.k_a);
  scene.material.eta = draw.log_uniform_or(0.0, 1e-2, 1e3);
  return scene;
}

double work_of(const Composition& composition) {
  const Rates& rates = composition.rates;
  const double omega = std::sqrt(rates.lattice.omega_squared + rates.wall);
  const double implicit = kStiffDamping * omega;
  const double gamma = rates.lattice.gamma;
  const double rate = omega + (!composition.bodies->is_alone() ? gamma : std::min(gamma, implicit));
  return static_cast<double>(composition.initial.position.rows()) * composition.expected_time *
         rate;
}

/// At the start, or of a point where it comes into reach of an elastic wall.
double wall_energy(const Composition& composition) {
  ForceField field = composition.field;
  PointArray force;
  field.resize(force);
  field.evaluate_undamped(composition.initial.position, force);
  const double at_start = field.wall_potential_energy(composition.initial.position);
  const Contact& contact = *field.contact();
  return std::max(at_start, contact.potential_at(contact.threshold()));
}

bool is_sensible_impact(const Scene& scene) {
  const double v = scene.impact.velocity;
  if (v > kLargestStrain * std::sqrt(scene.material.k_a)) return false;
  Scene however_long = scene;
  however_long.numerics.longest = std::numeric_limits<double>::infinity();
  const Composition composition = compose(however_long);
  return wall_energy(composition) < 0.5 * v * v && work_of(composition) <= kMostWorkOfScene;
}

bool is_sensible_contact(const Scene& scene) {
  const double load = scene.load.p / scene.material.k_a;
  return load <= kLargestStrain && scene.numerics.error * load >= kStrainRounding;
}

bool can_be_made(const Scene& scene) {
  try {
    make_bodies(scene);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

RandomScene random_scene(std::uint64_t seed, int number) {
  constexpr int kKinds = 5;
  Draw draw(seed, number);
  for (int rejected = 0;; ++rejected) {
    const Scene scene = draw_scene(draw, number % kKinds);
    if (can_be_made(scene) && is_sensible(scene)) return {scene, rejected};
  }
}

RandomScene random_slow_scene(std::uint64_t seed, int number) {
  Draw draw(seed, number);
  for (int rejected = 0;; ++rejected) {
    const Scene scene = draw_slow_scene(draw);
    if (!can_be_made(scene)) continue;
    const Composition composition = compose(scene);
    const IntegratorKind integrator = composition.resolution.integrator;
    const bool is_slow = moves_less_than_all(integrator) || integrator == IntegratorKind::kImex;
    if (is_slow && work_of(composition) <= kMostWorkOfSlowScene) return {scene, rejected};
  }
}

bool is_sensible(const Scene& scene) {
  return scene.kind == SceneKind::kContact ? is_sensible_contact(scene) : is_sensible_impact(scene);
}

double work_of(const Scene& scene) { return work_of(compose(scene)); }

std::string impact_command(const Scene& scene) {
  const std::string kind = kind_of(scene);
  std::string command =
      fmt::format("impact launch/scenes/{}.yaml", kind == "contact"        ? "contact"
                                                  : kind == "elastic wall" ? "absorbing_wall"
                                                                           : "collision");
  for (const auto& parameter : scene_parameters()) {
    if (parameter.key == "scene" || !parameter.applies(scene)) continue;
    const std::string value = parameter.write(scene).Scalar();
    if (!value.empty()) command += fmt::format(" {}={}", parameter.key, value);
  }
  return command;
}

std::string kind_of(const Scene& scene) {
  if (scene.kind == SceneKind::kContact) return "contact";
  return scene.wall.kind == WallKind::kLattice ? "elastic wall" : "potential wall";
}

}  // namespace impact
