#include "nodes/series_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "measure/flags.hpp"
#include "nodes/checksum.hpp"
#include "nodes/inventory.hpp"
#include "scene/keys.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

/// The question of the run was answered.
bool is_answered(const lattice_impact::RunStatus& status) {
  return status.phase == lattice_impact::RunStatus::FINISHED &&
         !has_flag(status.flags, Flag::kNotSeparated) && !has_flag(status.flags, Flag::kNotAtRest);
}

/// Whether e of the states is not the answer, by more than the errors. Where the simulation knows
/// no error, the two are one.
bool disagrees(const lattice_impact::Restitution& message) {
  const double difference = std::abs(message.restitution_of_run - message.restitution);
  const double allowed =
      std::isnan(message.restitution_of_run_error) ? 0.0 : message.restitution_of_run_error;
  return message.complete != 0 && !(difference <= allowed);
}

const char* phase_flag(const lattice_impact::RunStatus& status) {
  switch (status.phase) {
    case lattice_impact::RunStatus::FAILED:
      return name_of(Flag::kFailed);
    case lattice_impact::RunStatus::INTERRUPTED:
      return name_of(Flag::kInterrupted);
    default:
      return nullptr;
  }
}

}  // namespace

void SeriesAnalysis::add(const lattice_impact::Lattice& message) {
  Run& run = open_run(message.run);
  run.checksum += checksum_of(message);
  const std::string fault = run.checks.fault_of(message);
  if (fault.empty()) {
    run.strain_meter.emplace(from_message(message).points);
  } else {
    damage(run, message.run, "lattice: " + fault);
  }
  advance(message.run);
}

void SeriesAnalysis::add(const lattice_impact::ParticleStates& message) {
  open_run(message.run).states.push_back(message);
  advance(message.run);
}

void SeriesAnalysis::add(const lattice_impact::ContactForces& message) {
  open_run(message.run).forces.push_back(message);
  advance(message.run);
}

void SeriesAnalysis::add(const lattice_impact::RunStatus& message) {
  Run& run = open_run(message.run);
  std::string fault = RunChecks::fault_of(message);
  if (run.status && run.status->scene != message.scene)
    fault = "not the scene of the status before";
  run.status = message;
  if (!run.scene) {
    try {
      run.scene = parse_scene(parse_keys(message.scene, "scene"));
      run.impact = ImpactAnalysis(run.scene->gravity);
    } catch (const std::exception& error) {
      fault = error.what();
    }
  }
  if (!fault.empty()) {
    damage(run, message.run, fmt::format("run_status {}: {}", message.sequence, fault));
  }
  series_ended_ = has_ended(run.status) && (message.run + 1 == message.runs ||
                                            message.phase != lattice_impact::RunStatus::FINISHED);
  advance(message.run);
}

void SeriesAnalysis::advance(std::uint32_t number) {
  Run& run = open_run(number);
  const bool is_known = (run.strain_meter && run.scene) || run.damaged;
  while (is_known && !run.states.empty() && !run.forces.empty()) {
    const std::uint32_t sequence =
        std::max(run.states.front().sequence, run.forces.front().sequence);
    if (sequence != run.next_sequence && !run.damaged) report_gap(run, number, sequence);
    if (run.states.front().sequence < sequence) {
      run.states.pop_front();
    } else if (run.forces.front().sequence < sequence) {
      run.forces.pop_front();
    } else {
      take_in(run, run.states.front(), run.forces.front());
      run.states.pop_front();
      run.forces.pop_front();
      outputs_.taken_in(number, sequence);
    }
  }
  if (has_ended(run.status) && run.next_sequence >= run.status->states) close(number);
}

void SeriesAnalysis::take_in(Run& run, const lattice_impact::ParticleStates& states,
                             const lattice_impact::ContactForces& forces) {
  run.next_sequence = states.sequence + 1;
  run.checksum += checksum_of(states) + checksum_of(forces);
  if (!run.damaged) {
    const std::string fault =
        run.checks.fault_of(states, forces, *run.scene, *run.status, !run.gap);
    if (!fault.empty()) {
      damage(run, states.run,
             fmt::format("particle_states and contact_forces {}: {}", states.sequence, fault));
    }
  }
  if (run.damaged) return;
  const State state = from_message(states);
  run.impact.add(state);
  run.impact.add(from_message(forces));

  lattice_impact::Strain strain = to_message(run.strain_meter->measure(state.position));
  strain.header = states.header;
  strain.run = states.run;
  strain.step = states.step;
  strain.time = states.time;
  strain.force = forces.total_y;
  publish_strain(run, strain);
  if (!run.announced && run.scene->kind == SceneKind::kCollision) {
    run.announced = true;
    publish_restitution(run, false, false);
  }
}

void SeriesAnalysis::damage(Run& run, std::uint32_t number, const std::string& what) const {
  if (!run.damaged) outputs_.problem(fmt::format("run {}: damaged: {}", number, what));
  run.damaged = true;
}

void SeriesAnalysis::report_gap(Run& run, std::uint32_t number, std::uint32_t found) const {
  if (!run.gap) {
    outputs_.problem(fmt::format("run {}: messages are missing: expected sequence {}, got {}",
                                 number, run.next_sequence, found));
  }
  run.gap = true;
}

void SeriesAnalysis::publish_strain(Run& run, lattice_impact::Strain strain) const {
  strain.sequence = run.strains_published++;
  run.last_strain = strain;
  outputs_.strain(strain);
}

void SeriesAnalysis::publish_restitution(const Run& run, bool ended, bool complete) const {
  lattice_impact::Restitution message = answer_of(run, complete);
  message.header = run.last_strain.header;
  message.run = run.last_strain.run;
  message.ended = static_cast<std::uint8_t>(ended);
  message.complete = static_cast<std::uint8_t>(complete);
  message.flags = run.status->flags;
  if (const char* flag = phase_flag(*run.status)) message.flags.emplace_back(flag);
  if (run.gap) message.flags.emplace_back(name_of(Flag::kIncomplete));
  if (run.damaged) message.flags.emplace_back(name_of(Flag::kDamaged));
  if (disagrees(message)) message.flags.emplace_back(name_of(Flag::kDisagrees));
  outputs_.restitution(message);
}

lattice_impact::Restitution SeriesAnalysis::answer_of(const Run& run, bool complete) {
  const Restitution of_run = run.impact.restitution(complete);
  lattice_impact::Restitution message = to_message(of_run);
  copy_numbers(Restitution{}, message.error);
  message.restitution_of_run = of_run.restitution;
  message.restitution_of_run_error = Restitution::kNaN;
  if (!complete) copy_numbers(Restitution{}, message);
  if (run.damaged) message.velocity_before = Restitution::kNaN;
  if (!complete) return message;
  copy_numbers(run.status->answer, message);
  message.error = run.status->answer_error;
  message.restitution_of_run_error = run.status->restitution_of_run_error;
  message.velocity_after = -message.restitution * of_run.velocity_before;
  return message;
}

void SeriesAnalysis::close(std::uint32_t number) {
  Run& run = open_run(number);
  if (run.scene) {
    if (!run.gap && has_ended(run.status)) {
      const std::string fault = run.checks.fault_at_end(*run.status, *run.scene, run.next_sequence);
      if (!fault.empty()) damage(run, number, fault);
      const std::uint64_t said = run.status->checksum;
      if (said != 0 && said != checksum_with(run.checksum, *run.status)) {
        damage(run, number, "the checksum does not hold: a message is not as it was published");
      }
    }
    const bool complete = !run.gap && !run.damaged && is_answered(*run.status);
    if (run.scene->kind == SceneKind::kCollision) publish_restitution(run, true, complete);
    if (run.scene->kind == SceneKind::kContact && complete) {
      run.last_strain.at_rest = static_cast<std::uint8_t>(true);
      publish_strain(run, run.last_strain);
    }
    report_closed(run, number, complete);
  }
  const std::uint32_t states = run.status ? run.status->states : run.next_sequence;
  runs_.erase(number);
  outputs_.taken_in(number, states);
}

void SeriesAnalysis::report_closed(const Run& run, std::uint32_t number, bool complete) const {
  ClosedRun closed;
  closed.header = run.last_strain.header;
  closed.number = number;
  closed.scene = *run.scene;
  closed.flags = run.status->flags;
  if (complete) {
    closed.answer = run.scene->kind == SceneKind::kContact ? run.last_strain.strain
                                                           : run.status->answer.restitution;
  }
  outputs_.closed(closed);
}

void SeriesAnalysis::close() {
  while (!runs_.empty()) give_up(runs_.begin()->first);
}

void SeriesAnalysis::close_ended() {
  std::vector<std::uint32_t> ended;
  for (const auto& [number, run] : runs_) {
    if (has_ended(run.status)) ended.push_back(number);
  }
  for (const std::uint32_t number : ended) give_up(number);
}

void SeriesAnalysis::give_up(std::uint32_t number) {
  Run& run = open_run(number);
  run.gap = true;
  outputs_.problem(fmt::format("run {}: incomplete after {} states{}", number, run.next_sequence,
                               has_ended(run.status) ? fmt::format(" of {}", run.status->states)
                                                     : ", its end was not announced"));
  close(number);
}

bool SeriesAnalysis::waits_for_missing() const {
  return std::any_of(runs_.begin(), runs_.end(),
                     [](const auto& run) { return has_ended(run.second.status); });
}

}  // namespace impact
