#include "run/run.hpp"

#include <cmath>
#include <utility>

namespace impact {
namespace {

constexpr std::uint64_t kEnergyCheckSteps = 64;
constexpr double kPatience = 20.0;  // in expected times
constexpr int kMostHalvings = 20;

/// The force above which a point is listed as in contact: 10⁻⁶ of the load, or of M v c/R.
double contact_force(const Scene& scene) {
  return 1e-6 * (scene.kind == SceneKind::kContact ? scene.load.p : scene.impact.velocity);
}

}  // namespace

Run::Run(const Scene& scene, Composition composition)
    : scene_(scene),
      expected_time_(composition.expected_time),
      end_(end_of_run(scene, composition)),
      lattice_(std::move(composition.lattice)),
      simulation_(std::move(composition.field), std::move(composition.initial),
                  composition.spectrum, composition.step),
      monitor_(simulation_.ledger()),
      recorder_(simulation_, contact_force(scene)) {
  if (scene.kind == SceneKind::kCollision) {
    const double v = scene.impact.velocity;
    const double relative_energy = 2.0 * simulation_.ledger().wall / (v * v);
    restitution_bound_ = std::sqrt(1.0 + relative_energy);
    if (relative_energy > scene.numerics.error) flags_.emplace_back("starts_in_wall");
  }
}

void Run::advance() {
  ++outputs_;
  const double target = static_cast<double>(outputs_) * scene_.output.period;
  while (!finished_ && state().time < target - 0.5 * simulation_.step_size()) {
    simulation_.step();
    observe_step();
  }
}

void Run::observe_step() {
  recorder_.add_step(simulation_);
  if (simulation_.halvings() > kMostHalvings) {
    throw RunFailure("the wall grew too stiff: the step was halved more than 20 times");
  }
  if (state().step % kEnergyCheckSteps == 0) monitor_.check(simulation_);
  if (end_->reached(simulation_)) {
    finish();
  } else if (state().time > kPatience * expected_time_) {
    flags_.emplace_back(end_->flag_if_given_up());
    finish();
  }
}

void Run::finish() {
  finished_ = true;
  monitor_.check(simulation_);
  if (simulation_.halvings() > 0) flags_.emplace_back("step_reduced");
}

}  // namespace impact
