#include "run/contact_recorder.hpp"

#include <algorithm>
#include <utility>

namespace impact {
namespace {

/// The contact force along y; 0 without a contact.
ForceSample sample_of(const System& system) {
  const Contact* const contact = system.field().contact();
  return {system.time(), contact != nullptr ? contact->total_force().y() : 0.0};
}

void number_within(const Body& body, std::vector<PointForce>& forces) {
  for (PointForce& force : forces) force.point -= static_cast<std::int32_t>(body.first);
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
  reports.on_first = std::exchange(report_, ContactReport{});
  reports.on_first.time = reports.on_second.time = state.time;
  reports.on_first.step = reports.on_second.step = state.step;
  if (const Contact* const contact = field.contact()) {
    reports.on_first.total = contact->total_force();
    reports.on_second.total = -contact->total_force();
    reports.on_first.points = contact->contacts(state.position, contact_force_);
    reports.on_second.points = contact->reactions(state.position, contact_force_);
    if (field.second_body) number_within(*field.second_body, reports.on_second.points);
  }
  return reports;
}

}  // namespace impact
