#include "mechanics/lane_field.hpp"

#include <limits>
#include <numeric>

namespace impact {

bool LaneField::knows(const ForceField& field) {
  const bool at_a_wall = field.wall || (field.elastic_wall && !field.damped());
  return at_a_wall && !field.load && !field.hold;
}

LaneField::LaneField(const Lattice& lattice, double mass, Kind kind, const Kernels& kernels)
    : point_mass(mass),
      kind_(kind),
      kernels_(&kernels.lanes),
      points_(lattice.points.rows()),
      begin_(static_cast<std::size_t>(points_) + 1, 0),
      natural_length_(lattice.natural_lengths) {
  for (const Bond& bond : lattice.bonds) {
    ++begin_[static_cast<std::size_t>(bond.first) + 1];
    end_.push_back(bond.second);
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  if (kind.damped) relative_speeds_squared_.resize((points_ + 1) / 2);
  for (int lane = 0; lane < kLanes; ++lane) clear_lane(lane);
}

void LaneField::set_lane(int lane, ForceField& field) {
  const BondLaw& bonds = field.bonds.law();
  k_a_(lane) = bonds.k_a;
  k_b_(lane) = bonds.k_b;
  eta_(lane) = bonds.eta;
  if (field.wall) {
    const WallLaw wall = field.wall->law();
    wall_a_(lane) = wall.a;
    wall_force_at_zero_(lane) = wall.force_at_zero;
    wall_reach_(lane) = wall.reach;
  }
  fields_[static_cast<std::size_t>(lane)] = &field;
  if (kind_.damped) latest_ = field;
}

void LaneField::clear_lane(int lane) {
  for (LaneNumbers* const constants :
       {&k_a_, &k_b_, &eta_, &wall_a_, &wall_force_at_zero_, &wall_total_, &wall_largest_}) {
    (*constants)(lane) = 0.0;
  }
  wall_reach_(lane) = -std::numeric_limits<double>::infinity();
  fields_[static_cast<std::size_t>(lane)] = nullptr;
}

void LaneField::add_own_terms(const LaneArray& position, LaneArray& force) {
  for (int lane = 0; lane < kLanes; ++lane) {
    ForceField* const field = fields_[static_cast<std::size_t>(lane)];
    if (field == nullptr) continue;
    field->elastic_wall->add_forces(position.lane(lane), force.lane(lane));
    if (field->supports) field->supports->apply(force.lane(lane));
  }
}

LaneNumbers LaneField::evaluate(bool damped, const LaneArray& position, const double* velocity,
                                LaneArray& force) {
  ++evaluations;
  const LaneBondKernel bonds =
      damped ? (kind_.cubic ? kernels_->cubic_damped : kernels_->linear_damped)
             : (kind_.cubic ? kernels_->cubic : kernels_->linear);
  LaneNumbers relative_speed_squared;
  bonds({{begin_.data(), end_.data(), natural_length_.data()},
         k_a_.data(),
         k_b_.data(),
         eta_.data(),
         position.data(),
         velocity,
         force.data(),
         relative_speeds_squared_.data(),
         relative_speed_squared.data()},
        points_);
  if (kind_.elastic_wall) {
    add_own_terms(position, force);
  } else {
    kernels_->potential_wall({wall_a_.data(), wall_force_at_zero_.data(), wall_reach_.data()},
                             position.data(), points_, force.data(), wall_total_.data(),
                             wall_largest_.data());
  }
  return 0.5 * eta_ * relative_speed_squared;
}

LaneLosses LaneField::evaluate(const LaneArray& position, const LaneArray& velocity,
                               LaneArray& force) {
  return {evaluate(damped(), position, velocity.data(), force), LaneNumbers::Zero()};
}

void LaneField::evaluate_undamped(const LaneArray& position, LaneArray& force) {
  evaluate(false, position, nullptr, force);
}

}  // namespace impact
