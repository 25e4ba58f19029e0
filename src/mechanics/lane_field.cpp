#include "mechanics/lane_field.hpp"

#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace impact {

bool LaneField::knows(const ForceField& field) {
  // The loops of the lanes have either a potential wall or what acts by itself. One factor solves
  // for x and y.
  const bool has_contact =
      field.wall ? !field.supports
                 : (field.elastic_wall || field.disk_contacts) &&
                       (!field.supports || field.supports->held(0) == field.supports->held(1));
  bool known = !field.bonds.has_two_laws();
  field.for_each_term(
      [&](const auto& term) { known = known && std::decay_t<decltype(term)>::kInLanes; });
  return known && has_contact;
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
  if (field.bonds.has_two_laws()) throw std::logic_error("lanes know bonds of one law only");
  const BondLaw& bonds = field.bonds.law();
  k_a_(lane) = bonds.k_a;
  k_b_(lane) = bonds.k_b;
  eta_(lane) = bonds.eta;
  field.for_each_term([&](const auto& term) {
    using Term = std::decay_t<decltype(term)>;
    if constexpr (Term::kInLanes) {
      take(lane, term);
    } else {
      throw std::logic_error(std::string("lanes do not know the term ") + Term::kName);
    }
  });
  fields_[static_cast<std::size_t>(lane)] = &field;
  if (kind_.damped) latest_ = field;
}

void LaneField::take(int lane, const PotentialWall& wall) {
  const WallLaw law = wall.law();
  wall_a_(lane) = law.a;
  wall_force_at_zero_(lane) = law.force_at_zero;
  wall_reach_(lane) = law.reach;
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
    if (field->elastic_wall) field->elastic_wall->add_forces(position.lane(lane), force.lane(lane));
    if (field->disk_contacts) {
      field->disk_contacts->add_forces(position.lane(lane), force.lane(lane));
    }
    if (field->supports) field->supports->constrain(force.lane(lane));
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
  if (kind_.own_terms) {
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
