#include "run/run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace impact {
namespace {

constexpr std::uint64_t kCheckSteps = 64;
constexpr std::uint64_t kAlarmSteps = 4;
constexpr int kMostHalvings = 20;
constexpr double kManyHops = 0.01;  // of the impact's energy

/// The force above which a point is listed as in contact: 10⁻⁶ of the load, or of M v c/R.
double contact_force(const Scene& scene) {
  return 1e-6 * (scene.kind == SceneKind::kContact ? scene.load.p : scene.impact.velocity);
}

/// Whether a point that comes into reach of an elastic wall finds more than negligible energy
/// there.
bool is_cut_off(const Scene& scene, const ForceField& field) {
  return field.elastic_wall && field.elastic_wall->potential_at(field.elastic_wall->threshold()) >
                                   negligible_wall_energy(scene);
}

/// Whether contacts that passed from bond to bond, or over the edge of the wall, changed the energy
/// of the impact by more than a little.
bool hops_matter(const Scene& scene, const Simulation& simulation) {
  const double impact_energy = 0.5 * scene.impact.velocity * scene.impact.velocity;
  return simulation.field().elastic_wall &&
         simulation.field().elastic_wall->hops_size() > kManyHops * impact_energy;
}

}  // namespace

Run::Run(const Scene& scene, std::shared_ptr<const Composition> composition,
         const Resolution& resolution)
    : scene_(scene),
      composition_(std::move(composition)),
      end_(end_of_run(scene, *composition_, resolution.step)),
      triangles_(lattice()),
      simulation_(composition_->field, composition_->initial, composition_->rates.lattice,
                  resolution.step,
                  make_integrator(scene, resolution, composition_->rates.sound_speed)),
      monitor_(simulation_.ledger()),
      recorder_(simulation_, contact_force(scene)),
      integrator_(resolution.integrator) {
  if (wall_lattice() != nullptr) wall_triangles_.emplace(*wall_lattice());
  if (scene.kind == SceneKind::kCollision) {
    const double v = scene.impact.velocity;
    const double relative_energy = 2.0 * simulation_.ledger().wall / (v * v);
    restitution_bound_ = std::sqrt(1.0 + relative_energy);
    if (relative_energy > scene.numerics.error) flags_.emplace_back("starts_in_wall");
    if (is_cut_off(scene, simulation_.field())) flags_.emplace_back("cut_off");
  }
}

void Run::advance(const std::function<bool()>& stop) {
  if (scene_.is_static()) {
    settle();
    return;
  }
  constexpr double kRounding = 1e-6;  // of a period
  const double period = scene_.output.period;
  const double target = (std::floor(state().time / period + kRounding) + 1.0 - kRounding) * period;
  while (!finished_ && state().time < target) {
    simulation_.step();
    observe_step();
    if (stop && state().step % kCheckSteps == 0 && stop()) return;
  }
}

bool Run::has_flag(const std::string& flag) const {
  return std::find(flags_.begin(), flags_.end(), flag) != flags_.end();
}

State Run::disk_state() const {
  const Eigen::Index points = lattice().points.rows();
  return {state().time, state().step, state().position.topRows(points),
          state().velocity.topRows(points)};
}

State Run::wall_state() const {
  const Eigen::Index points = simulation_.field().wall_points;
  return {state().time, state().step, state().position.bottomRows(points),
          state().velocity.bottomRows(points)};
}

void Run::settle() {
  if (!simulation_.settle(
          negligible_static_force(scene_, state().position.rows(), simulation_.step_size()))) {
    flags_.emplace_back(end_->flag_if_given_up());
  }
  note_folds();
  if (folded_) flags_.emplace_back("folded");
  recorder_.add_step(simulation_);
  finished_ = true;
}

void Run::reload(double p) {
  simulation_.reload(p);
  scene_.load.p = p;
  recorder_ = ContactRecorder(simulation_, contact_force(scene_));
  flags_.clear();
  folded_ = false;
  finished_ = false;
}

void Run::observe_step() {
  recorder_.add_step(simulation_);
  if (simulation_.halvings() > kMostHalvings) {
    throw RunFailure("the wall grew too stiff: the step was halved more than 20 times");
  }
  if (state().step % kCheckSteps == 0) {
    look();
  } else if (state().step % kAlarmSteps == 0 && monitor_.is_alarming(simulation_)) {
    monitor_.check(simulation_);
  }
  if (end_->reached(simulation_)) {
    finish();
  } else if (state().time > kPatience * expected_time()) {
    flags_.emplace_back(end_->flag_if_given_up());
    finish();
  }
}

void Run::look() {
  monitor_.check(simulation_);
  note_folds();
}

void Run::note_folds() {
  const PointArray& position = state().position;
  folded_ = folded_ || triangles_.turned_over(position.topRows(lattice().points.rows())) > 0;
  if (!wall_triangles_) return;
  const auto wall = position.bottomRows(wall_lattice()->points.rows());
  folded_ = folded_ || wall_triangles_->turned_over(wall) > 0;
}

void Run::finish() {
  finished_ = true;
  look();
  if (scene_.numerics.are_given() && monitor_.error() > scene_.numerics.error) {
    flags_.emplace_back("energy_error");
  }
  if (folded_) flags_.emplace_back("folded");
  if (hops_matter(scene_, simulation_)) flags_.emplace_back("hops");
  if (simulation_.halvings() > 0) flags_.emplace_back("step_reduced");
}

}  // namespace impact
