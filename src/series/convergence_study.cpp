#include "series/convergence_study.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

/// A quantity that is a real number.
template <class Number>
Quantity number(std::string key, Number value) {
  return {std::move(key), [value](const ConvergenceStudy& e) { return value(e); }};
}

/// A term of the energy ledger at the end.
Quantity energy(std::string key, double EnergyLedger::*term) {
  return number(std::move(key), [term](const auto& e) { return e.run().system().ledger().*term; });
}

std::vector<Quantity> impact_quantities(const Scene& scene) {
  std::vector<Quantity> list;
  list.push_back(number("velocity", [](const auto& e) { return e.scene().impact.velocity; }));
  const auto has = [&scene](const std::string& key) {
    if (is_of_sliding(key)) return scene.impact.slides();
    if (is_of_row(key)) return scene.is_row();
    const std::size_t disk = disk_of(key);
    return disk == 0 || (scene.hits_disk() && disk <= scene.other_bodies());
  };
  for (const auto& [key, member] : impact_numbers<Restitution>()) {
    if (!has(key)) continue;
    list.push_back(
        number(key, [member = member](const auto& e) { return e.impact().value.*member; }));
  }
  for (const auto& [key, member] : impact_numbers<Restitution>()) {
    if (!has(key)) continue;
    list.push_back(number(std::string(key) + "_error",
                          [member = member](const auto& e) { return e.impact().error.*member; }));
  }
  list.push_back(number("restitution_of_run",
                        [](const auto& e) { return e.restitution_of_run().restitution; }));
  list.push_back(
      number("restitution_of_run_error", [](const auto& e) { return e.impact().error_of_run; }));
  list.push_back(
      number("restitution_bound", [](const auto& e) { return e.run().restitution_bound(); }));
  if (scene.impact.slides() && scene.has_elastic_wall()) {
    list.push_back(number("surface_slope", [](const auto& e) { return e.run().surface_slope(); }));
  }
  list.push_back(energy("dissipated", &EnergyLedger::dissipated));
  if (scene.has_elastic_wall()) {
    list.push_back(energy("wall_energy", &EnergyLedger::wall_lattice));
    list.push_back(energy("absorbed", &EnergyLedger::absorbed));
  }
  if (scene.other_bodies() > 0) list.push_back(energy("hops", &EnergyLedger::hops_size));
  return list;
}

std::vector<Quantity> contact_quantities(const Scene& scene) {
  std::vector<Quantity> list;
  list.push_back(number("P", [](const auto& e) { return e.scene().load.p; }));
  list.push_back(number("strain", [](const auto& e) { return e.strain().strain(); }));
  list.push_back(
      number("strain_from_radius", [](const auto& e) { return e.strain().strain_from_radius(); }));
  list.push_back(number("wall_force", [](const auto& e) {
    return e.run().system().field().wall->total_force().y();
  }));
  list.push_back(number("rotation", [](const auto& e) { return e.strain().rotation; }));
  if (scene.load.hold_rotation) {
    list.push_back(number("hold_torque",
                          [](const auto& e) { return e.run().system().field().hold->torque(); }));
  }
  list.push_back(number("largest_static_force",
                        [](const auto& e) { return e.run().system().largest_static_force(); }));
  return list;
}

std::vector<Quantity> stretch_quantities() {
  std::vector<Quantity> list;
  list.push_back(
      number("young_modulus", [](const auto& e) { return e.elastic_constants().young_modulus; }));
  list.push_back(
      number("poisson_ratio", [](const auto& e) { return e.elastic_constants().poisson_ratio; }));
  list.push_back(number("sound_speed", [](const auto& e) {
    return std::sqrt(M_PI * e.elastic_constants().young_modulus);
  }));
  list.push_back(number("grip_modulus", [](const auto& e) { return e.grip_modulus(); }));
  list.push_back(number("largest_static_force",
                        [](const auto& e) { return e.run().system().largest_static_force(); }));
  return list;
}

/// What every result ends with.
std::vector<Quantity> run_quantities() {
  std::vector<Quantity> list;
  list.push_back(number("energy_error", [](const auto& e) { return e.run().energy_error(); }));
  list.push_back(number("estimated_error", [](const auto& e) { return e.estimated_error(); }));
  list.push_back({"integrator", [](const auto& e) { return name_of(e.run().integrator()); }});
  list.push_back(number("step", [](const auto& e) { return e.run().system().step_size(); }));
  list.push_back(
      number("steps", [](const auto& e) { return static_cast<double>(e.run().state().step); }));
  list.push_back(number("wall_time", [](const auto& e) { return e.wall_time(); }));
  list.push_back({"flags", [](const auto& e) { return e.run().flags(); }});
  return list;
}

}  // namespace

ConvergenceStudy::ConvergenceStudy(const Scene& scene,
                                   const std::shared_ptr<const Composition>& composition,
                                   History* history)
    : ConvergenceStudy(scene, composition, nullptr, history) {}

ConvergenceStudy::ConvergenceStudy(const Scene& scene,
                                   std::shared_ptr<const Composition> composition, MakeRun make_run,
                                   History* history)
    : scene_(scene),
      composition_(std::move(composition)),
      make_run_(std::move(make_run)),
      ahead_(make_run_ || history != nullptr ? nullptr
                                             : std::make_unique<RunsAhead>(scene, composition_)),
      control_(scene, *composition_),
      history_(history) {
  start_run();
}

void ConvergenceStudy::start_run() {
  make_way();
  analysis_ = ImpactAnalysis(scene_.gravity);
  show(composition_->field, start_of(*composition_, control_.resolution()), analysis_);
  run_.emplace(next_run());
  ++runs_;
  if (history_ == nullptr) return;
  history_->start();
  take_in();
}

/// Leaves the memory of the present run, which can be looked at as long as one waits for the next,
/// to that one.
void ConvergenceStudy::make_way() {
  if (ahead_) {
    ahead_->begin(control_.resolution(), control_.later_resolutions());
    ahead_->wait_for(control_.resolution(), stop_);
  }
  run_.reset();
}

Run ConvergenceStudy::next_run() {
  const Resolution& resolution = control_.resolution();
  if (make_run_) return make_run_(resolution);
  return ahead_ ? ahead_->take(resolution, stop_) : Run(scene_, composition_, resolution);
}

void ConvergenceStudy::advance(const std::function<bool()>& stop) {
  stop_ = stop;
  go_on([&] { run_->advance(stop); });
}

void ConvergenceStudy::observe_step() {
  go_on([&] { run_->observe_step(); });
}

void ConvergenceStudy::observe_solution(const EquilibriumSearch& search) {
  go_on([&] { run_->observe_solution(search); });
}

template <class Move>
void ConvergenceStudy::go_on(const Move& move) {
  try {
    move();
  } catch (const RunFailure& failure) {
    control_.take_failure(failure);
    start_run();
    return;
  }
  if (history_ != nullptr && !run_->finished()) take_in();
  while (run_->finished() && !finished_) {
    take_in();
    end_run();
  }
}

void ConvergenceStudy::end_run() {
  finished_ = control_.accepts(*run_, restitution_of_run());
  if (!finished_) start_run();
}

void ConvergenceStudy::take_in() {
  const ContactReports reports = run_->take_contact_reports();
  run_->show(analysis_);
  analysis_.add(reports.on_first);
  if (history_ != nullptr) history_->add(*run_, strain(), reports);
}

Restitution ConvergenceStudy::restitution_of_run() const {
  return analysis_.restitution(!run_->has_flag(Flag::kNotSeparated));
}

Strain ConvergenceStudy::strain() const {
  return StrainMeter(composition_->bodies->disk().points).measure(run_->disk_state().position);
}

double ConvergenceStudy::answer() const {
  return scene_.kind == SceneKind::kContact ? strain().strain() : impact().value.restitution;
}

ElasticConstants ConvergenceStudy::elastic_constants() const {
  const MiddleRegion middle{scene_.stretch.width / 4.0, scene_.stretch.height / 4.0};
  const ElasticConstants constants =
      stretched_constants(run_->lattice(), run_->state().position, law(), middle);
  if (!std::isfinite(constants.young_modulus) || !std::isfinite(constants.poisson_ratio)) {
    throw RunFailure("the middle of the rectangle has too few points for a mean strain");
  }
  return constants;
}

double ConvergenceStudy::grip_modulus() const {
  const MiddleRegion all{scene_.stretch.width / 2.0, scene_.stretch.height / 2.0};
  const double pull = mean_stress(run_->lattice(), run_->state().position, law(), all)(0, 0);
  return pull / scene_.stretch.strain;
}

BondLaw ConvergenceStudy::law() const { return {scene_.material.k_a, scene_.material.k_b, 0.0}; }

double ConvergenceStudy::wall_time() const {
  if (given_wall_time_) return *given_wall_time_;
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

Result ConvergenceStudy::result() const {
  Result result;
  for (const Quantity& quantity : quantities(scene_)) {
    result.entries.emplace_back(quantity.key, quantity.value(*this));
  }
  return result;
}

std::vector<Quantity> quantities(const Scene& scene) {
  std::vector<Quantity> list;
  switch (scene.kind) {
    case SceneKind::kCollision:
      list = impact_quantities(scene);
      break;
    case SceneKind::kContact:
      list = contact_quantities(scene);
      break;
    case SceneKind::kStretch:
      list = stretch_quantities();
      break;
  }
  for (Quantity& quantity : run_quantities()) list.push_back(std::move(quantity));
  return list;
}

}  // namespace impact
