#include "nodes/run_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

#include "measure/flags.hpp"
#include "mechanics/body.hpp"
#include "mechanics/body_motion.hpp"
#include "nodes/conversions.hpp"
#include "nodes/mean.hpp"

namespace impact {
namespace {

using lattice_impact::RunStatus;
using Array = std::pair<const char*, const std::vector<double>*>;

std::string fault_of_arrays(std::size_t size, std::initializer_list<Array> arrays) {
  for (const auto& [name, values] : arrays) {
    if (values->size() != size) {
      return fmt::format("{} has {} values for {}", name, values->size(), size);
    }
    const auto odd = std::find_if_not(values->begin(), values->end(),
                                      [](double value) { return std::isfinite(value); });
    if (odd != values->end()) return fmt::format("{}[{}] = {}", name, odd - values->begin(), *odd);
  }
  return {};
}

std::string fault_of_numbers(std::initializer_list<std::pair<const char*, double>> numbers) {
  for (const auto& [name, value] : numbers) {
    if (!std::isfinite(value)) return fmt::format("{} = {}", name, value);
  }
  return {};
}

/// The first that is not empty.
std::string first_of(std::initializer_list<std::string> faults) {
  const auto* const fault = std::find_if(faults.begin(), faults.end(),
                                         [](const std::string& text) { return !text.empty(); });
  return fault == faults.end() ? std::string() : *fault;
}

bool differ(double a, double b, double tolerance) { return !(std::abs(a - b) <= tolerance); }

/// The part of the velocity at which disks meet that the first one has; empty: not known, since the
/// others come from a file.
std::optional<double> share_of_velocity(const Scene& scene, std::size_t points) {
  if (!scene.hits_disk()) return 1.0;
  const auto number = static_cast<double>(points);
  const auto of_each = scene.points_of_row_disk(number);
  if (!of_each) return std::nullopt;
  return reduced_mass(scene.wall.disks * *of_each / number);
}

}  // namespace

std::string RunChecks::fault_of(const lattice_impact::Lattice& lattice) {
  points_ = lattice.x.size();
  constexpr std::size_t kLeastPoints = 3;
  if (points_ < kLeastPoints) return fmt::format("{} points", points_);
  const std::size_t bonds = lattice.bond_first.size();
  if (lattice.bond_second.size() != bonds) {
    return fmt::format("bond_second has {} values for {}", lattice.bond_second.size(), bonds);
  }
  for (std::size_t k = 0; k < bonds; ++k) {
    if (lattice.bond_first[k] >= lattice.bond_second[k] || lattice.bond_second[k] >= points_) {
      return fmt::format("bond {} joins points {} and {} of {}", k, lattice.bond_first[k],
                         lattice.bond_second[k], points_);
    }
  }
  return first_of({fault_of_arrays(points_, {{"x", &lattice.x}, {"y", &lattice.y}}),
                   fault_of_arrays(bonds, {{"natural_length", &lattice.natural_length}}),
                   fault_of_numbers({{"point_mass", lattice.point_mass}})});
}

std::string RunChecks::fault_of(const lattice_impact::ParticleStates& states,
                                const lattice_impact::ContactForces& forces, const Scene& scene,
                                const RunStatus& status, bool follows) {
  std::string fault = first_of(
      {fault_of_arrays(
           points_, {{"x", &states.x}, {"y", &states.y}, {"vx", &states.vx}, {"vy", &states.vy}}),
       fault_of_arrays(forces.point.size(), {{"fx", &forces.fx}, {"fy", &forces.fy}}),
       fault_of_arrays(forces.sample_time.size(), {{"sample_time", &forces.sample_time},
                                                   {"sample_force", &forces.sample_force}}),
       fault_of_numbers({{"time", states.time},
                         {"total_x", forces.total_x},
                         {"total_y", forces.total_y},
                         {"impulse", forces.impulse},
                         {"peak_force", forces.peak_force}})});
  if (!fault.empty()) return fault;
  if (std::any_of(forces.point.begin(), forces.point.end(),
                  [this](std::uint32_t point) { return point >= points_; })) {
    return fmt::format("a force on a point that is not there, of {}", points_);
  }
  if (states.step != forces.step || states.time != forces.time) {
    return fmt::format("step {} at {} R/c, of the forces {} at {}", states.step, states.time,
                       forces.step, forces.time);
  }
  if (!follows) return {};
  const double velocity = mean(states.vy);
  const Trapezoid sum = trapezoid(forces);
  std::string wrong = fault_of_samples(forces, sum, status.integrator != "newton");
  if (wrong.empty() && scene.kind == SceneKind::kCollision) {
    wrong = fault_of_momentum(velocity, states.time, sum, scene, status.step_size);
    if (wrong.empty() && states_ == 0) wrong = fault_of_sliding(from_message(states), scene);
  }
  ++states_;
  last_step_ = states.step;
  last_velocity_ = velocity;
  last_time_ = states.time;
  if (!forces.sample_time.empty()) {
    last_sample_ = {forces.sample_time.back(), forces.sample_force.back()};
  }
  return wrong;
}

RunChecks::Trapezoid RunChecks::trapezoid(const lattice_impact::ContactForces& forces) const {
  Trapezoid sum;
  std::optional<ForceSample> last = last_sample_;
  for (std::size_t k = 0; k < forces.sample_time.size(); ++k) {
    const ForceSample sample{forces.sample_time[k], forces.sample_force[k]};
    if (last) {
      const double part = 0.5 * (last->force + sample.force) * (sample.time - last->time);
      sum.impulse += part;
      sum.size += std::abs(part);
    }
    last = sample;
  }
  return sum;
}

std::string RunChecks::fault_of_samples(const lattice_impact::ContactForces& forces,
                                        const Trapezoid& sum, bool every_step) const {
  const std::size_t samples = forces.sample_time.size();
  if (forces.step < last_step_) {
    return fmt::format("step {} after {}", forces.step, last_step_);
  }
  const std::uint64_t steps = forces.step - last_step_ + (states_ == 0 ? 1 : 0);
  if (every_step && samples != steps) return fmt::format("{} samples of {} steps", samples, steps);
  if (samples > 0 && forces.sample_time.back() != forces.time) {
    return fmt::format("the last sample is of {} R/c, the forces of {}", forces.sample_time.back(),
                       forces.time);
  }
  double last = last_sample_ ? last_sample_->time : -std::numeric_limits<double>::infinity();
  for (const double time : forces.sample_time) {
    if (time <= last) return fmt::format("a sample of {} R/c after one of {}", time, last);
    last = time;
  }
  constexpr double kRounding = 1e-12;
  if (differ(sum.impulse, forces.impulse, kRounding * sum.size)) {
    return fmt::format("impulse {}, of the samples {}", forces.impulse, sum.impulse);
  }
  return {};
}

std::string RunChecks::fault_of_momentum(double velocity, double time, const Trapezoid& sum,
                                         const Scene& scene, double step_size) const {
  constexpr double kRounding = 1e-6;
  if (states_ == 0) {
    const auto share = share_of_velocity(scene, points_);
    if (!share) return {};
    const double v = *share * scene.impact.normal_velocity();
    return differ(velocity, -v, kRounding * v)
               ? fmt::format("velocity {} c at the start, of the scene {}", velocity, -v)
               : std::string();
  }
  const double way = scene.wall_rate() * step_size;
  const double tolerance = kRounding * scene.impact.normal_velocity() + way * way * sum.size;
  const double change = velocity - last_velocity_ + scene.gravity * (time - last_time_);
  return differ(change, sum.impulse, tolerance)
             ? fmt::format("the momentum changes by {} M c, the impulse is {}", change, sum.impulse)
             : std::string();
}

std::string RunChecks::fault_of_sliding(const State& start, const Scene& scene) {
  const auto share = share_of_velocity(scene, static_cast<std::size_t>(start.position.rows()));
  if (!share) return {};
  const BodyMotion motion = body_motion(start.position, start.velocity);
  const double rounding = 1e-6 * (scene.impact.velocity + std::abs(scene.impact.spin));
  const double tangential = *share * scene.impact.tangential_velocity();
  if (differ(motion.velocity.x(), tangential, rounding)) {
    return fmt::format("velocity {} c along x at the start, of the scene {}", motion.velocity.x(),
                       tangential);
  }
  if (differ(motion.spin(), scene.impact.spin, rounding)) {
    return fmt::format("spin {} c/R at the start, of the scene {}", motion.spin(),
                       scene.impact.spin);
  }
  return {};
}

std::string RunChecks::fault_of(const RunStatus& status) {
  if (status.phase > RunStatus::INTERRUPTED) return fmt::format("phase {}", status.phase);
  if (status.run >= status.runs) return fmt::format("run {} of {}", status.run, status.runs);
  if (status.bodies < 1 || status.bodies > kMostBodies) {
    return fmt::format("{} bodies", status.bodies);
  }
  return {};
}

std::string RunChecks::fault_at_end(const RunStatus& status, const Scene& scene,
                                    std::uint32_t states) const {
  if (states > status.states) return fmt::format("{} states, {} announced", states, status.states);
  if (status.bodies != 1 + scene.other_bodies()) {
    return fmt::format("{} bodies, of the scene {}", status.bodies, 1 + scene.other_bodies());
  }
  const bool gave_up = has_flag(status.flags, Flag::kNotSeparated);
  if (status.phase != RunStatus::FINISHED || scene.kind != SceneKind::kCollision || gave_up) {
    return {};
  }
  if (last_velocity_ <= 0.0) return "finished, but the disk has not come off the wall";
  if (!(status.answer.restitution > 0.0)) {
    return fmt::format("finished, with the restitution {}", status.answer.restitution);
  }
  return {};
}

}  // namespace impact
