#include "run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mechanics/simulation.hpp"
#include "run/expected_time.hpp"
#include "run/make_integrator.hpp"
#include "run/other_rests.hpp"
#include "run/slow_impact.hpp"
#include "statics/equilibrium_solver.hpp"

namespace impact {
namespace {

constexpr std::uint64_t kCheckSteps = 64;
constexpr std::uint64_t kAlarmSteps = 4;
constexpr int kMostHalvings = 20;
constexpr double kManyHops = 0.01;  // of the impact's energy
constexpr std::uint64_t kSlopeSteps = 4;
constexpr double kPushed = 0.01;  // of the largest force on a point

/// The force above which a point is listed as in contact: 10⁻⁶ of the load, or of M v c/R.
double contact_force(const Scene& scene) {
  return 1e-6 * (scene.kind == SceneKind::kContact ? scene.load.p : scene.impact.normal_velocity());
}

/// The energy along y of the centres of mass of what comes together.
double impact_energy(const Scene& scene, const ForceField& field) {
  return impact_energy(scene, field.reduced_mass());
}

/// Whether a point that comes into reach of a surface finds more than negligible energy there.
bool is_cut_off(const Scene& scene, const ForceField& field) {
  const Contact& contact = *field.contact();
  return contact.potential_at(contact.threshold()) >
         negligible_fraction(scene) * impact_energy(scene, field);
}

/// Whether contacts that passed from bond to bond, or over the edge of the wall, changed the energy
/// of the impact by more than a little.
bool hops_matter(const Scene& scene, const System& system) {
  const Contact* const contact = system.field().contact();
  return contact != nullptr &&
         contact->hops_size() > kManyHops * impact_energy(scene, system.field());
}

/// Whether a part of the disk that the wall would push lies beside it.
bool is_beside_wall(const Scene& scene, const System& system) {
  const Contact* const contact = system.field().contact();
  return contact != nullptr && contact->energy_beside(system.state().position) >
                                   scene.numerics.error * impact_energy(scene, system.field());
}

/// To the next output time, a step where steps are not shortened on the way.
template <class Moving>
void step_to_output(Moving& simulation, double interval, Run& run,
                    const std::function<bool()>& stop) {
  constexpr double kRounding = 1e-6;  // of an interval
  const double target =
      (std::floor(simulation.time() / interval + kRounding) + 1.0 - kRounding) * interval;
  while (!run.finished() && simulation.time() < target) {
    simulation.step();
    run.observe_step();
    if (stop && simulation.steps() % kCheckSteps == 0 && stop()) return;
  }
}

template <class Moving>
DrivenSystem driven(std::unique_ptr<Moving> motion, double interval) {
  Moving& moving = *motion;
  return {std::move(motion), [&moving, interval](Run& run, const auto& stop) {
            step_to_output(moving, interval, run, stop);
          }};
}

DrivenSystem simulated(const Scene& scene, const Composition& composition,
                       const Resolution& resolution) {
  const double interval = output_interval(scene, resolution.step);
  if (resolution.integrator == IntegratorKind::kReduced) {
    return driven(slow_impact(scene, composition, resolution), interval);
  }
  if (resolution.integrator == IntegratorKind::kModal) {
    return driven(modal_impact(scene, composition, resolution), interval);
  }
  return driven(
      std::make_unique<Simulation>(
          composition.field, start_of(composition, resolution), composition.rates.lattice,
          resolution.step, make_integrator(scene, resolution, composition.rates.sound_speed)),
      interval);
}

DrivenSystem solved(const Scene& scene, const Composition& composition) {
  auto search = make_search(scene, composition);
  EquilibriumSearch& driven = *search;
  return {std::move(search), [&driven](Run& run, const auto& stop) {
            if (solve(driven, stop)) run.observe_solution(driven);
          }};
}

}  // namespace

void show(const ForceField& field, const State& state, ImpactAnalysis& analysis) {
  if (field.others.empty()) {
    analysis.add(state);
    return;
  }
  const auto part = [&](const Body& body) {
    return State{state.time, state.step, body.rows_of(state.position),
                 body.rows_of(state.velocity)};
  };
  std::vector<State> others;
  for (const Body& body : field.others) {
    if (body.is_free) others.push_back(part(body));
  }
  analysis.add(part(field.first_body()), others);
}

Run::Run(const Scene& scene, const std::shared_ptr<const Composition>& composition,
         const Resolution& resolution)
    : Run(scene, composition, resolution,
          scene.is_static() ? solved(scene, *composition)
                            : simulated(scene, *composition, resolution)) {}

Run::Run(const Scene& scene, std::shared_ptr<const Composition> composition,
         const Resolution& resolution, DrivenSystem driven)
    : scene_(scene),
      composition_(std::move(composition)),
      end_(end_of_run(scene, *composition_, resolution.step)),
      system_(std::move(driven.system)),
      drive_(std::move(driven.drive)),
      monitor_(system_->ledger()),
      recorder_(*system_, contact_force(scene)),
      flags_(composition_->bodies->flags),
      integrator_(resolution.integrator) {
  if (scene.kind != SceneKind::kCollision) return;
  if (scene.impact.slides() && scene.has_elastic_wall()) slope_.emplace(system_->time());
  const double energy = impact_energy(scene, system_->field());
  const EnergyLedger ledger = system_->ledger();
  contact_energy_before_ = ledger.wall;
  const double relative_energy = ledger.wall / energy;
  const double other_motion = ledger.kinetic() + ledger.bonds - energy;
  restitution_bound_ = scene.impact.slides()
                           ? std::sqrt(1.0 + relative_energy + other_motion / energy)
                           : std::sqrt(1.0 + relative_energy);
  if (relative_energy > scene.numerics.error) flags_.emplace_back(name_of(Flag::kStartsInWall));
  if (is_cut_off(scene, system_->field())) flags_.emplace_back(name_of(Flag::kCutOff));
}

void Run::advance(const std::function<bool()>& stop) {
  if (!finished_) drive_(*this, stop);
}

State Run::state_of(const Body& body) const {
  return {system_->time(), system_->steps(), body.rows_of(state().position),
          body.rows_of(state().velocity)};
}

double Run::surface_slope() const {
  return slope_ ? slope_->mean() : std::numeric_limits<double>::quiet_NaN();
}

double Run::tail_error() const {
  const double v = system_->field().first_body().rows_of(state().velocity).col(1).mean();
  const double before = scene_.impact.gap ? 0.0 : contact_energy_before_;
  return 0.5 * before / system_->field().impact_energy(v) + 0.5 * end_->remaining_energy();
}

void Run::observe_step() {
  recorder_.add_step(*system_);
  if (slope_ && system_->steps() % kSlopeSteps == 0) note_slope();
  if (system_->halvings() > kMostHalvings) {
    throw RunFailure("the wall grew too stiff: the step was halved more than 20 times");
  }
  if (moves_less_than_all(integrator_) && was_pressed_most()) note_folds();
  if (system_->steps() % kCheckSteps == 0) {
    look();
  } else if (system_->steps() % kAlarmSteps == 0 && monitor_.is_alarming(*system_)) {
    monitor_.check(*system_);
  }
  if (end_->reached(*system_)) {
    end_motion();
  } else if (system_->time() > kPatience * expected_time() + end_->time_under_way()) {
    give_up();
    end_motion();
  }
}

/// A static solution, at which the energy that damped motion would lose is not known, has no energy
/// balance.
void Run::observe_solution(const EquilibriumSearch& search) {
  recorder_.add_step(*system_);
  if (!end_->reached(*system_)) give_up();
  note_folds();
  correction_ = search.correction();
  finish();
}

/// E and ν have no error control that looks at flags.
void Run::give_up() {
  if (scene_.kind == SceneKind::kStretch) {
    throw RunFailure(
        fmt::format("no state of rest was found: after {} steps a point still feels {:.1e} M c²/R",
                    system_->steps(), system_->largest_static_force()));
  }
  flags_.emplace_back(name_of(end_->flag_if_given_up()));
}

void Run::look() {
  monitor_.check(*system_);
  note_folds();
  beside_wall_ = beside_wall_ || is_beside_wall(scene_, *system_);
}

void Run::note_slope() {
  const Contact& contact = *system_->field().contact();
  const double force = contact.total_force().y();
  if (!(force > contact_force(scene_))) {
    slope_->add(system_->time(), 0.0, 0.0);
    return;
  }
  const PointArray& position = state().position;
  const auto pushed = contact.reactions(position, kPushed * contact.largest_force());
  slope_->add(system_->time(), force, chord_slope(pushed, position));
}

void Run::note_other_rests() {
  if (scene_.kind != SceneKind::kContact || scene_.load.hold_rotation) return;
  if (has_flag(Flag::kNotAtRest)) return;
  if (rests_elsewhere(scene_, *composition_, disk_state().position)) {
    flags_.emplace_back(name_of(Flag::kSeveralRests));
  }
}

void Run::note_folds() {
  const std::vector<BodyOfScene>& all = composition_->bodies->all;
  if (moves_less_than_all(integrator_)) {
    const BodyOfScene& disk = all.front();
    const double left = disk.triangles.least_area_left(disk.lattice.points, state().position);
    folded_ = folded_ || left < ModelError::kLeastAreaLeft;
    return;
  }
  for (std::size_t k = 0; k < all.size() && !folded_; ++k) {
    const Body body = system_->field().body(k);
    folded_ = all[k].triangles.turned_over(body.rows_of(state().position)) > 0;
  }
}

/// At the step before, more than ever.
bool Run::was_pressed_most() {
  const double before = std::exchange(force_, system_->field().contact()->total_force().y());
  if (before < largest_force_) return false;
  largest_force_ = before;
  return force_ < before;
}

void Run::end_motion() {
  look();
  if (scene_.numerics.are_given() && monitor_.error() > scene_.numerics.error) {
    flags_.emplace_back(name_of(Flag::kEnergyError));
  }
  if (scene_.kind == SceneKind::kContact) {
    correction_ = equilibrium_correction(system_->field(), state());
  }
  finish();
}

void Run::finish() {
  finished_ = true;
  if (folded_) flags_.emplace_back(name_of(Flag::kFolded));
  if (beside_wall_) flags_.emplace_back(name_of(Flag::kBesideWall));
  if (hops_matter(scene_, *system_)) flags_.emplace_back(name_of(Flag::kHops));
  note_other_rests();
  if (system_->halvings() > 0) flags_.emplace_back(name_of(Flag::kStepReduced));
}

std::unique_ptr<EquilibriumSearch> make_search(const Scene& scene, const Composition& composition) {
  const Eigen::Index points = composition.initial.position.rows();
  return std::make_unique<EquilibriumSearch>(
      composition.field, composition.initial,
      negligible_static_force(scene, points, composition.resolution.step));
}

}  // namespace impact
