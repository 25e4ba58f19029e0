#include "mechanics/lane_bundle.hpp"

#include <algorithm>
#include <utility>

namespace impact {

LaneMotion::LaneMotion(ForceField field, State initial, const Spectrum& spectrum, double step,
                       std::unique_ptr<FixedStepIntegrator<ForceField>> integrator)
    : Simulation(std::move(field), std::move(initial), spectrum, step, std::move(integrator)),
      alone_(static_cast<FixedStepIntegrator<ForceField>*>(integrator_.get())) {}

LaneMotion::~LaneMotion() { leave(); }

void LaneMotion::leave() {
  if (bundle_ != nullptr) bundle_->release(*this);
}

const State& LaneMotion::state() const {
  if (!is_current_) bundle_->read(lane_, state_);
  is_current_ = true;
  return state_;
}

double LaneMotion::kinetic_energy() const {
  return bundle_ != nullptr ? 0.5 * field_.point_mass * squared_speed_ : System::kinetic_energy();
}

LaneBundle::LaneBundle(const Lattice& lattice, double point_mass, LaneField::Kind kind,
                       std::unique_ptr<FixedStepIntegrator<LaneField>> integrator,
                       bool needs_common_step)
    : field_(lattice, point_mass, kind),
      integrator_(std::move(integrator)),
      needs_common_step_(needs_common_step) {
  field_.resize(state_.position);
  field_.resize(state_.velocity);
  integrator_->restart(field_, state_);
}

LaneBundle::~LaneBundle() {
  for (LaneMotion* const motion : motions_) {
    if (motion != nullptr) motion->leave();
  }
}

void LaneBundle::add(LaneMotion& motion) {
  auto* const free = std::find(motions_.begin(), motions_.end(), nullptr);
  const auto lane = static_cast<int>(free - motions_.begin());
  field_.set_lane(lane, motion.field_);
  state_.position.lane(lane) = motion.state_.position;
  state_.velocity.lane(lane) = motion.state_.velocity;
  integrator_->take_lane(lane, *motion.alone_);

  motion.bundle_ = this;
  motion.lane_ = lane;
  *free = &motion;
  ++occupied_;
  look_at_speeds();
}

void LaneBundle::release(LaneMotion& motion) {
  motion.LaneMotion::state();  // also at the end of its life
  integrator_->give_lane(motion.lane_, *motion.alone_);
  motion.bundle_ = nullptr;
  motions_[static_cast<std::size_t>(motion.lane_)] = nullptr;
  step_size_(motion.lane_) = 0.0;
  field_.clear_lane(motion.lane_);
  --occupied_;
}

void LaneBundle::step() {
  for (LaneMotion* const motion : motions_) {
    if (motion == nullptr) continue;
    const int halvings = motion->halvings();
    motion->limit_step(*motion->field_.contact(), motion->approach_, *integrator_);
    step_size_(motion->lane_) = motion->step_size();
    if (needs_common_step_ && motion->halvings() > halvings) motion->leave();
  }
  if (occupied_ == 0) return;
  const std::uint64_t evaluations = field_.evaluations;
  const LaneLosses lost = integrator_->step(field_, state_, step_size_);
  for (LaneMotion* const motion : motions_) {
    if (motion != nullptr) take_step(*motion, lost, field_.evaluations - evaluations);
  }
  look_at_speeds();
}

/// What Simulation does at the end of a step.
void LaneBundle::take_step(LaneMotion& motion, const LaneLosses& lost, std::uint64_t evaluations) {
  const int lane = motion.lane_;
  ForceField& field = motion.field_;
  field.evaluations += evaluations;
  if (field.wall) {
    const WallForce wall = field_.wall_force(lane);
    field.wall->take_in({0.0, wall.total}, wall.largest);
  } else {
    field.count_hops(state_.position.lane(lane));
  }
  motion.is_current_ = false;
  motion.count_step({lost.dissipated(lane), lost.absorbed(lane)});
  if (motion.reset_is_due()) reset_velocities(motion);
}

void LaneBundle::reset_velocities(LaneMotion& motion) {
  const int lane = motion.lane_;
  motion.losses_.absorbed +=
      motion.field_.velocity_reset->apply(state_.velocity.lane(lane), field_.point_mass);
  if (!field_.damped()) return;
  motion.LaneMotion::state();
  integrator_->give_lane(lane, *motion.alone_);
  motion.alone_->take_velocity(motion.field_, motion.state_);
  integrator_->take_lane(lane, *motion.alone_);
}

void LaneBundle::look_at_speeds() {
  LaneNumbers squared = LaneNumbers::Zero();
  LaneNumbers down = LaneNumbers::Zero();
  LaneNumbers approach = LaneNumbers::Zero();
  auto* const any =
      std::find_if(motions_.begin(), motions_.end(), [](auto* m) { return m != nullptr; });
  const ForceField& field = (*any)->field_;
  for (std::size_t number = 0; number < field.number_of_bodies(); ++number) {
    const Body body = field.body(number);
    LaneNumbers lowest;
    LaneNumbers up;
    kernels().lanes.speeds(state_.velocity.data() + Eigen::Index{2} * kLanes * body.first,
                           body.points, squared.data(), lowest.data(), up.data());
    if (number > 0) approach = approach.max(up + down);
    down = down.max(-lowest);
  }
  if (field.others.empty()) approach = down;
  for (LaneMotion* const motion : motions_) {
    if (motion == nullptr) continue;
    motion->approach_ = approach(motion->lane_);
    motion->squared_speed_ = squared(motion->lane_);
  }
}

void LaneBundle::read(int lane, State& state) const {
  state.position = state_.position.lane(lane);
  state.velocity = state_.velocity.lane(lane);
}

}  // namespace impact
