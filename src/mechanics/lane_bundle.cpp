#include "mechanics/lane_bundle.hpp"

#include <algorithm>
#include <utility>

namespace impact {

LaneMotion::LaneMotion(ForceField field, State initial, const Spectrum& spectrum, double step)
    : Motion(std::move(field), std::move(initial), spectrum, step) {
  PointArray force(state_.position.rows(), 2);
  field_.evaluate(state_.position, state_.velocity, force);
}

LaneMotion::~LaneMotion() {
  if (bundle_ != nullptr) bundle_->leave(*this);
}

const State& LaneMotion::state() const {
  if (!is_current_) bundle_->read(lane_, state_);
  is_current_ = true;
  return state_;
}

double LaneMotion::kinetic_energy() const {
  return bundle_ != nullptr ? 0.5 * field_.point_mass * squared_speed_ : Motion::kinetic_energy();
}

LaneBundle::LaneBundle(const Lattice& lattice, double point_mass, LaneField::Kind kind,
                       const MakeIntegrator& make_integrator, bool needs_common_step)
    : field_(lattice, point_mass, kind),
      integrator_(make_integrator()),
      beginner_(make_integrator()),
      needs_common_step_(needs_common_step) {
  field_.resize(state_.position);
  field_.resize(state_.velocity);
  integrator_->restart(field_, state_);
}

LaneBundle::~LaneBundle() {
  for (LaneMotion* const motion : motions_) {
    if (motion != nullptr) leave(*motion);
  }
}

void LaneBundle::board(LaneMotion& motion) {
  const auto free = std::find(motions_.begin(), motions_.end(), nullptr);
  const auto lane = static_cast<int>(free - motions_.begin());
  field_.set_lane(lane, motion.field_);
  state_.position.lane(lane) = motion.state_.position;
  state_.velocity.lane(lane) = motion.state_.velocity;
  beginner_->restart(field_, state_);
  integrator_->take_lane(*beginner_, lane);

  motion.bundle_ = this;
  motion.lane_ = lane;
  motion.approach_ = std::max(0.0, -motion.state_.velocity.col(1).minCoeff());
  motion.squared_speed_ = motion.state_.velocity.square().sum();
  *free = &motion;
  ++on_board_;
}

void LaneBundle::leave(LaneMotion& motion) {
  motion.state();
  motion.bundle_ = nullptr;
  motions_[static_cast<std::size_t>(motion.lane_)] = nullptr;
  step_size_(motion.lane_) = 0.0;
  field_.clear_lane(motion.lane_);
  --on_board_;
}

void LaneBundle::step() {
  for (LaneMotion* const motion : motions_) {
    if (motion == nullptr) continue;
    const int halvings = motion->halvings();
    motion->limit_step(*motion->field_.wall, motion->approach_, *integrator_);
    step_size_(motion->lane_) = motion->step_size();
    if (needs_common_step_ && motion->halvings() > halvings) leave(*motion);
  }
  if (on_board_ == 0) return;
  const std::uint64_t evaluations = field_.evaluations;
  const LaneLosses lost = integrator_->step(field_, state_, step_size_);
  LaneNumbers squared_speed;
  LaneNumbers lowest_speed;
  kernels().lanes.speeds(state_.velocity.data(), state_.velocity.points(), squared_speed.data(),
                         lowest_speed.data());
  for (LaneMotion* const motion : motions_) {
    if (motion == nullptr) continue;
    const int lane = motion->lane_;
    motion->is_current_ = false;
    motion->approach_ = -lowest_speed(lane);
    motion->squared_speed_ = squared_speed(lane);
    motion->field_.evaluations += field_.evaluations - evaluations;
    const WallForce wall = field_.wall_force(lane);
    motion->field_.wall->take_in({0.0, wall.total}, wall.largest);
    motion->count_step({lost.dissipated(lane), lost.absorbed(lane)});
  }
}

void LaneBundle::read(int lane, State& state) const {
  state.position = state_.position.lane(lane);
  state.velocity = state_.velocity.lane(lane);
}

}  // namespace impact
