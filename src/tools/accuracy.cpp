#include "tools/accuracy.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "scene/scene_parameters.hpp"
#include "tools/experiment.hpp"

namespace impact {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kReferenceError = 1e-10;
constexpr double kStiffDamping = 30.0;  // η*, from which on explicit methods take minutes

class Draw {
 public:
  Draw(std::uint64_t seed, int number) {
    std::seed_seq sequence{seed, seed >> 32U, static_cast<std::uint64_t>(number)};
    random_.seed(sequence);
  }

  int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }
  bool coin() { return below(2) == 0; }
  double log_uniform(double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>(0.0, 1.0)(random_));
  }

 private:
  std::mt19937_64 random_;
};

void draw_elastic_wall(Draw& draw, Scene& scene) {
  constexpr double kWallByDisk = 1269.0 / 1099.0;  // points, as in the paper
  scene.wall.kind = WallKind::kLattice;
  scene.wall.points = static_cast<int>(std::lround(kWallByDisk * scene.disk.recipe.points));
  scene.wall.boundary = static_cast<Boundary>(draw.below(3));
  scene.wall.gap = draw.coin() ? GapMeasure::kNormal : GapMeasure::kVertical;
}

Experiment performed(const Scene& scene) {
  Experiment experiment(scene);
  while (!experiment.finished()) experiment.advance();
  for (const char* flag : {"not_at_rest", "not_separated"}) {
    if (experiment.run().has_flag(flag)) throw RunFailure(flag);
  }
  return experiment;
}

Scene with(Scene scene, IntegratorKind integrator, double error = kReferenceError) {
  scene.numerics = {integrator, {}, {}, error};
  return scene;
}

Scene with_tolerance(Scene scene, double tolerance) {
  scene = with(scene, IntegratorKind::kRk8pd);
  scene.numerics.tolerance = tolerance;
  return scene;
}

Scene with_step(Scene scene, double step) {
  scene = with(scene, scene.is_damped() ? IntegratorKind::kExtrapolatedDamping
                                        : IntegratorKind::kBlanesMoan);
  scene.numerics.step = step;
  return scene;
}

ReferenceAnswer compared(double value, double other) {
  return {value, std::abs(other - value) / std::abs(value), {}};
}

ReferenceAnswer contact_reference(const Scene& scene) {
  Scene in_motion = with(scene, IntegratorKind::kImplicitDamping);
  in_motion.material.eta = scene.disk.recipe.points;
  return compared(performed(with(scene, IntegratorKind::kNewton)).answer(),
                  performed(in_motion).answer());
}

ReferenceAnswer impact_reference(const Scene& scene) {
  constexpr double kFineStep = 2e-3;
  if (scene.wall.kind == WallKind::kLattice) {
    return compared(performed(with_tolerance(scene, 1e-10)).answer(),
                    performed(with_step(scene, kFineStep)).answer());
  }
  const Experiment automatic = performed(with(scene, IntegratorKind::kAuto));
  if (scene.material.eta <= kStiffDamping) {
    return compared(performed(with_tolerance(scene, 1e-12)).answer(), automatic.answer());
  }
  const double half_step = 0.5 * automatic.run().motion().step_size();
  return compared(performed(with_step(scene, half_step)).answer(), automatic.answer());
}

}  // namespace

Scene random_scene(std::uint64_t seed, int number) {
  constexpr int kKinds = 5;
  Draw draw(seed, number);
  Scene scene;
  scene.disk.recipe.points = static_cast<int>(std::lround(draw.log_uniform(50.0, 2000.0)));
  scene.disk.recipe.placement = draw.coin() ? Placement::kUniform : Placement::kBlueNoise;
  scene.seed = 1U + static_cast<std::uint64_t>(draw.below(1000000));
  scene.material.k_b = draw.coin() ? draw.log_uniform(1e-3, 1e3) : 0.0;
  scene.wall.a = draw.log_uniform(100.0, 1000.0);
  if (number % kKinds == 0) {
    scene.kind = SceneKind::kContact;
    scene.load.p = draw.log_uniform(1e-3, 1e-2);
    return scene;
  }
  scene.impact.velocity = draw.log_uniform(0.003, 0.1);
  if (number % kKinds == 1) {
    draw_elastic_wall(draw, scene);
  } else {
    scene.material.eta = draw.coin() ? draw.log_uniform(0.1, 1000.0) : 0.0;
  }
  return scene;
}

std::vector<double> asked_errors(const Scene& scene) {
  if (scene.kind == SceneKind::kCollision && scene.wall.kind == WallKind::kLattice) {
    return {1e-2, 1e-3, 1e-4};
  }
  return {1e-3, 1e-5, 1e-7};
}

ReferenceAnswer reference_answer(const Scene& scene) {
  try {
    return scene.kind == SceneKind::kContact ? contact_reference(scene) : impact_reference(scene);
  } catch (const RunFailure& failure) {
    return {kNaN, std::numeric_limits<double>::infinity(), failure.what()};
  }
}

AccuracyTrial try_accuracy(Scene scene, double error, const ReferenceAnswer& reference) {
  scene.numerics.error = error;
  AccuracyTrial trial{error, "answered", "", kNaN, kNaN, kNaN, kNaN, kNaN};
  try {
    const Experiment experiment = performed(scene);
    trial.integrator = name_of(experiment.run().integrator());
    trial.step = experiment.run().motion().step_size();
    trial.answer = experiment.answer();
    trial.estimated_error = experiment.estimated_error();
    trial.true_error = std::abs(trial.answer / reference.value - 1.0);
    trial.wall_time = experiment.wall_time();
  } catch (const RunFailure& failure) {
    trial.status = failure.what();
  }
  return trial;
}

}  // namespace impact
