#include "run/contact_recorder.hpp"

#include <algorithm>
#include <utility>

namespace impact {

ContactRecorder::ContactRecorder(const Simulation& start, double contact_force)
    : contact_force_(contact_force), last_{start.state().time, start.field().wall->total_force()} {
  report_.samples.push_back(last_);
  report_.peak_force = last_.force;
}

void ContactRecorder::add_step(const Simulation& simulation) {
  const ForceSample sample{simulation.state().time, simulation.field().wall->total_force()};
  report_.impulse += 0.5 * (last_.force + sample.force) * (sample.time - last_.time);
  report_.peak_force = std::max(report_.peak_force, sample.force);
  report_.samples.push_back(sample);
  last_ = sample;
}

ContactReport ContactRecorder::take(const Simulation& simulation) {
  const PotentialWall& wall = *simulation.field().wall;
  const State& state = simulation.state();
  report_.time = state.time;
  report_.step = state.step;
  report_.total = {0.0, wall.total_force()};
  const double contact_height = wall.height_of_force(contact_force_);
  for (Eigen::Index i = 0; i < state.position.rows(); ++i) {
    const double height = state.position(i, 1);
    if (height > contact_height) continue;
    report_.points.push_back({static_cast<std::int32_t>(i), {0.0, wall.force_at(height)}});
  }
  return std::exchange(report_, ContactReport{});
}

}  // namespace impact
