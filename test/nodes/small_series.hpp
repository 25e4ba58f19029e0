#pragma once

#include <algorithm>
#include <cstdint>
#include <variant>
#include <vector>

#include "measure/impact_analysis.hpp"
#include "nodes/conversions.hpp"
#include "run/run.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {

using Message = std::variant<lattice_impact::Lattice, lattice_impact::ParticleStates,
                             lattice_impact::ContactForces, lattice_impact::RunStatus>;

inline Scene small_scene(SceneKind kind) {
  Scene scene;
  scene.kind = kind;
  scene.disk.recipe.points = 40;
  scene.output.period = 0.2;
  if (kind == SceneKind::kCollision) {
    scene.impact.velocity = 0.05;
  } else {
    scene.material.eta = 20.0;
    scene.load.p = 0.01;
  }
  return scene;
}

inline lattice_impact::RunStatus status_of(const Scene& scene, std::uint32_t run,
                                           std::uint32_t states, std::uint8_t phase) {
  lattice_impact::RunStatus status;
  status.run = run;
  status.runs = std::max(2U, run + 1);
  status.states = states;
  status.phase = phase;
  status.scene = to_yaml(scene);
  status.bodies = static_cast<std::uint32_t>(1 + scene.other_bodies());
  return status;
}

/// The messages of one run, in the order in which the simulation node sends them.
inline std::vector<Message> messages_of(const Scene& scene, std::uint32_t number) {
  Run run(scene);
  std::vector<Message> messages;
  lattice_impact::Lattice lattice = to_message(run.lattice());
  lattice.run = number;
  messages.emplace_back(lattice);
  const auto status = [&](std::uint32_t states, std::uint8_t phase) {
    lattice_impact::RunStatus message = status_of(scene, number, states, phase);
    message.integrator = name_of(run.integrator());
    message.step_size = run.system().step_size();
    return message;
  };
  messages.emplace_back(status(0, lattice_impact::RunStatus::RUNNING));
  std::uint32_t sequence = 0;
  ImpactAnalysis analysis(scene.gravity);
  const auto send = [&] {
    const ContactReport report = run.take_contact_reports().on_first;
    run.show(analysis);
    analysis.add(report);
    lattice_impact::ParticleStates states = to_message(run.disk_state());
    lattice_impact::ContactForces forces = to_message(report);
    states.run = forces.run = number;
    states.sequence = forces.sequence = sequence++;
    messages.emplace_back(states);
    messages.emplace_back(forces);
  };
  send();
  while (!run.finished()) {
    run.advance();
    send();
  }
  lattice_impact::RunStatus end = status(sequence, lattice_impact::RunStatus::FINISHED);
  end.answer = numbers_to_message(analysis.restitution(true));
  end.answer_error = numbers_to_message({});
  end.restitution_of_run_error = Restitution::kNaN;
  messages.emplace_back(end);
  return messages;
}

}  // namespace impact
