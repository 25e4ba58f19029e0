#include "reduced/left_out.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "reduced/excited_modes.hpp"

namespace impact {
namespace {

constexpr double kMarginOfManyPoints = 5.0;
constexpr double kMarginOfFewPoints = 15.0;
constexpr Eigen::Index kFewPoints = 100;
constexpr double kMarginOfOthers = 10.0;
/// By which derivatives are taken: the change of a height at the contact, in ranges of the wall,
/// and how far from the middle of the contact that is when the body turns (R).
constexpr double kLift = 0.03;
constexpr double kArm = 0.2;

/// Of a pose.
struct Strained {
  Eigen::ArrayXd u;  ///< displacements as in QuasiStaticContact::displacements(), R
  double beyond;     ///< ΔE, M c²
};

/// At a pose near that of this contact.
Strained strained(QuasiStaticContact contact, const ForceField& field, const Pose& pose) {
  contact.take(pose);
  const Eigen::ArrayXd u = contact.displacements({}).col(0);
  const Eigen::Index n = contact.arm().rows();
  PointArray position = contact.arm();
  position.col(0) += u.head(n);
  position.col(1) += u.tail(n);
  return {u, field.bonds.potential_energy(position) - contact.bond_energy()};
}

Strained slope(const Strained& before, const Strained& after, double way) {
  return {(after.u - before.u) / way, (after.beyond - before.beyond) / way};
}

/// |Δx| at this step, R.
double lever_error(const SlowImpact& impact, std::size_t place) {
  const Pose& pose = impact.poses[place];
  const double spin = impact.spins[place];
  const double lift = kLift / impact.field.wall->a();
  const double turn = lift / kArm;
  const auto [height, angle] = pose;
  QuasiStaticContact contact = impact.contact;
  contact.take(pose);
  const auto at = [&](const Pose& other) { return strained(contact, impact.field, other); };
  const Strained by_height =
      slope(at({height - lift, angle}), at({height + lift, angle}), 2.0 * lift);
  const Strained by_angle =
      slope(at({height, angle - turn}), at({height, angle + turn}), 2.0 * turn);
  const double lever = contact.torque() / contact.force();
  const double by_bulk = (lever * by_height.beyond - by_angle.beyond) / contact.force();
  const Eigen::ArrayXd across = lever * by_height.u - by_angle.u;
  const Eigen::ArrayXd acceleration = by_height.u + lever / impact.inertia * by_angle.u;
  const double by_inertia = impact.field.point_mass * (acceleration * across).sum();
  const double outwards = (contact.arm().reshaped() * across).sum();
  const double by_spin = impact.field.point_mass * spin * spin * outwards / contact.force();
  return std::abs(by_bulk) + std::abs(by_inertia) + std::abs(by_spin);
}

/// Where the force is greatest, and the first and the last step at which it is half of that.
std::array<std::size_t, 3> places_of(const std::vector<double>& forces) {
  const auto peak = std::max_element(forces.begin(), forces.end());
  const auto is_half = [&](double force) { return force >= 0.5 * *peak; };
  const auto first = std::find_if(forces.begin(), forces.end(), is_half);
  const auto last = std::find_if(forces.rbegin(), forces.rend(), is_half).base() - 1;
  const auto place = [&](auto force) { return static_cast<std::size_t>(force - forces.begin()); };
  return {place(peak), place(first), place(last)};
}

double fastest_change(const SlowImpact& impact) {
  double fastest = 0.0;
  for (std::size_t k = 1; k < impact.forces.size(); ++k) {
    fastest = std::max(fastest, std::abs(impact.forces[k] - impact.forces[k - 1]));
  }
  return fastest / impact.step;
}

/// Kinetic energy of the displacements when the force of the peak's shape changes fastest.
double kinetic_energy(const QuasiStaticContact& at_peak, const SlowImpact& impact) {
  const PointArray u = at_peak.displacements({});
  const double rate = fastest_change(impact) / at_peak.force();
  return 0.5 * impact.field.point_mass * u.col(0).square().sum() * rate * rate;
}

/// What the model never lets vibrate: what the force of its course would excite, and the energy of
/// bonds that it has at the start, where the points are in their places and the force may be there
/// all at once.
double energy_of_vibrations(const QuasiStaticContact& at_peak, const SlowImpact& impact) {
  QuasiStaticContact at_start = impact.contact;
  at_start.take(impact.poses.front());
  return at_start.bond_energy() +
         energy_of_vibrations(excited_modes(at_peak, impact.field.point_mass), impact.forces,
                              impact.step);
}

}  // namespace

ModelError left_out(const SlowImpact& impact) {
  const auto places = places_of(impact.forces);
  double lever = 0.0;
  for (const std::size_t place : places) {
    lever = std::max(lever, lever_error(impact, place));
  }
  const Pose& peak = impact.poses[places.front()];
  QuasiStaticContact at_peak = impact.contact;
  at_peak.take(peak);
  const double vibrations = energy_of_vibrations(at_peak, impact);
  const double energy = 0.5 * impact.speed_before * impact.speed_before;
  const double twice_left = impact.speed_after * impact.speed_after;
  const double spin = (impact.speed_before + impact.speed_after) * lever / impact.inertia;
  const double by_spin =
      impact.inertia * spin * (std::abs(impact.spins.back()) + 0.5 * spin) / twice_left;
  const double beyond = std::abs(strained(at_peak, impact.field, peak).beyond);
  const double others =
      (beyond + kinetic_energy(at_peak, impact)) / energy + std::sqrt(vibrations / energy);
  const double margin =
      at_peak.arm().rows() < kFewPoints ? kMarginOfFewPoints : kMarginOfManyPoints;
  return {margin * (by_spin + vibrations / twice_left), margin * spin, kMarginOfOthers * others};
}

}  // namespace impact
