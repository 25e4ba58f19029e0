#include "run/contact_recorder.hpp"

#include <algorithm>
#include <utility>

namespace impact {
namespace {

/// The wall force along y; 0 without a wall.
ForceSample sample_of(const System& system) {
  const WallContact* const contact = system.field().contact();
  return {system.time(), contact != nullptr ? contact->total_force().y() : 0.0};
}

}  // namespace

ContactRecorder::ContactRecorder(const System& start, double contact_force)
    : contact_force_(contact_force), last_(sample_of(start)) {
  report_.samples.push_back(last_);
  report_.peak_force = last_.force;
}

void ContactRecorder::add_step(const System& system) {
  const ForceSample sample = sample_of(system);
  report_.impulse += 0.5 * (last_.force + sample.force) * (sample.time - last_.time);
  report_.peak_force = std::max(report_.peak_force, sample.force);
  report_.samples.push_back(sample);
  last_ = sample;
}

ContactReports ContactRecorder::take(const System& system) {
  const ForceField& field = system.field();
  const State& state = system.state();
  ContactReports reports;
  reports.on_disk = std::exchange(report_, ContactReport{});
  reports.on_disk.time = reports.on_wall.time = state.time;
  reports.on_disk.step = reports.on_wall.step = state.step;
  if (const WallContact* const contact = field.contact()) {
    reports.on_disk.total = contact->total_force();
    reports.on_wall.total = -contact->total_force();
  }
  if (field.wall) reports.on_disk.points = field.wall->contacts(state.position, contact_force_);
  if (field.elastic_wall) {
    reports.on_disk.points = field.elastic_wall->contacts(state.position, contact_force_);
    reports.on_wall.points = field.elastic_wall->reactions(state.position, contact_force_);
  }
  return reports;
}

}  // namespace impact
