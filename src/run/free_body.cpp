#include "run/free_body.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/body_motion.hpp"

namespace impact {
namespace {

constexpr double kEnergyMargin = 1.1;
constexpr double kRounding = 1e-9;         // of an energy that is the difference of two
constexpr double kFirstOrder = 1.0 / 3.0;  // of the spacing

}  // namespace

InnerMotion inner_motion(const System& system, const Body& body, const BodyMotion& motion) {
  // Where it is calm, what is left of its kinetic energy is rounding, of either sign.
  constexpr double kRounding = 1e-12;
  const ForceField& field = system.field();
  const double mass = field.mass_of(body);
  const double kinetic = field.kinetic_energy(body, system.state());
  const double vibrations =
      std::max(0.0, kinetic - 0.5 * mass * motion.velocity.square().sum()) + kRounding * kinetic;
  return {vibrations + field.bond_energy(body, system.state()), mass * motion.angular_momentum};
}

double energy_margin(double energy) { return kEnergyMargin * energy; }

double elongation(double energy, double k_a) { return std::sqrt(2.0 * energy / k_a); }

double swing(const Flexibility& lattice, double elongation, double spacing) {
  return std::sqrt(lattice.compliance) * elongation * (1.0 + elongation / spacing);
}

FreeBody::FreeBody(const Lattice& lattice, const Triangles& triangles,
                   const Flexibility& flexibility, const Scene::Material& material, double spacing,
                   double mass)
    : lattice_(&lattice),
      triangles_(&triangles),
      flexibility_(flexibility),
      material_(material),
      reference_(about_the_centre(lattice.points)),
      spacing_(spacing),
      mass_(mass),
      gyration_(std::sqrt(reference_.square().sum() / static_cast<double>(reference_.rows()))) {}

InnerBounds FreeBody::bounds(const InnerMotion& motion) const {
  constexpr int kIterations = 3;
  constexpr double kLargestDisplacement = 0.25;  // of the radius of gyration
  const bool damped = material_.eta != 0.0;
  const double omega = flexibility_.lowest_frequency * std::sqrt(material_.k_a);
  const double all = energy_margin(motion.energy);
  const double l = std::abs(motion.angular_momentum);
  double energy = all;
  double displacement = std::sqrt(2.0 * energy) / omega;  // root mean square, of all points
  for (int k = 0; k < kIterations && !damped; ++k) {
    const double rotation = 0.5 * std::pow(l / (gyration_ + displacement), 2) / mass_;
    energy = energy_margin(std::max(0.0, motion.energy - rotation)) + kRounding * motion.energy;
    displacement = std::sqrt(2.0 * energy) / omega;
  }
  const double x = elongation(energy, material_.k_a);
  InnerBounds bounds{};
  bounds.hold = x <= kFirstOrder * spacing_ && displacement <= kLargestDisplacement * gyration_ &&
                std::isfinite(flexibility_.compliance);
  bounds.swing = swing(flexibility_, x, spacing_);
  const double least_gyration = gyration_ - displacement;
  if (damped) {
    bounds.clockwise = bounds.counter_clockwise = std::sqrt(2.0 * all / mass_) / least_gyration;
    return bounds;
  }
  const double least_inertia = mass_ * least_gyration * least_gyration;
  const double of_vibrations = energy * std::sqrt(mass_) / omega;
  const double along = (l + of_vibrations) / least_inertia;
  const double against = std::max(0.0, of_vibrations - l) / least_inertia;
  const bool turns_left = motion.angular_momentum > 0.0;
  bounds.counter_clockwise = turns_left ? along : against;
  bounds.clockwise = turns_left ? against : along;
  return bounds;
}

bool FreeBody::is_unfolded(const ConstPoints& position) const {
  return triangles_->turned_over(position) == 0;
}

double FreeBody::reach(const InnerMotion& motion, const ConstPoints& position) {
  const InnerBounds bound = bounds(motion);
  if (!bound.hold || !is_unfolded(position)) return reach_of_tethers(motion);
  return std::sqrt(reference_.square().rowwise().sum().maxCoeff()) + bound.swing;
}

double FreeBody::reach_of_tethers(const InnerMotion& motion) {
  if (!tethers_) tethers_.emplace(*lattice_);
  return tethers_->largest_distance(elongation(energy_margin(motion.energy), material_.k_a));
}

}  // namespace impact
