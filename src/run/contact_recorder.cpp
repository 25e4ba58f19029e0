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
  ContactReports reports;
  reports.on_first = std::exchange(report_, ContactReport{});
  reports.on_others.resize(field.others.size());
  enter(system, 0, reports.on_first);
  for (std::size_t k = 0; k < field.others.size(); ++k) enter(system, k + 1, reports.on_others[k]);
  return reports;
}

/// What acts on the body of this number now.
void ContactRecorder::enter(const System& system, std::size_t number, ContactReport& report) const {
  const State& state = system.state();
  report.time = state.time;
  report.step = state.step;
  const Contact* const contact = system.field().contact();
  if (contact == nullptr) return;
  report.total = contact->total_force_on(number);
  report.points = contact->forces_on(number, state.position, contact_force_);
  const Eigen::Index first_row = system.field().body(number).first;
  for (PointForce& force : report.points) force.point -= static_cast<std::int32_t>(first_row);
}

}  // namespace impact
