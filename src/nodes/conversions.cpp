#include "nodes/conversions.hpp"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

namespace impact {
namespace {

std::vector<double> column(const PointArray& points, Eigen::Index which) {
  const double* const begin = points.data() + which * points.rows();
  return {begin, begin + points.rows()};
}

PointArray points(const std::vector<double>& x, const std::vector<double>& y) {
  PointArray result(static_cast<Eigen::Index>(x.size()), 2);
  std::copy(x.begin(), x.end(), result.data());
  std::copy(y.begin(), y.end(), result.data() + result.rows());
  return result;
}

void require_equal(const char* message, std::initializer_list<std::size_t> sizes) {
  if (std::adjacent_find(sizes.begin(), sizes.end(), std::not_equal_to<>()) != sizes.end()) {
    throw std::runtime_error(std::string(message) + ": its arrays differ in length");
  }
}

template <class Message>
void copy_energies(const EnergyLedger& ledger, double error, Message& message) {
  message.kinetic_translation = ledger.kinetic_translation;
  message.kinetic_rotation = ledger.kinetic_rotation;
  message.kinetic_internal = ledger.kinetic_internal;
  message.bonds = ledger.bonds;
  message.wall = ledger.wall;
  message.load = ledger.load;
  message.dissipated = ledger.dissipated;
  message.wall_lattice = ledger.wall_lattice;
  message.absorbed = ledger.absorbed;
  message.hops = ledger.hops;
  message.hops_size = ledger.hops_size;
  message.total = ledger.total();
  message.error = error;
}

}  // namespace

lattice_impact::Lattice to_message(const Lattice& lattice) {
  lattice_impact::Lattice message;
  message.x = column(lattice.points, 0);
  message.y = column(lattice.points, 1);
  for (const Bond& bond : lattice.bonds) {
    message.bond_first.push_back(static_cast<std::uint32_t>(bond.first));
    message.bond_second.push_back(static_cast<std::uint32_t>(bond.second));
  }
  message.natural_length = lattice.natural_lengths;
  return message;
}

lattice_impact::ParticleStates to_message(const State& state) {
  lattice_impact::ParticleStates message;
  message.step = state.step;
  message.time = state.time;
  message.x = column(state.position, 0);
  message.y = column(state.position, 1);
  message.vx = column(state.velocity, 0);
  message.vy = column(state.velocity, 1);
  return message;
}

lattice_impact::ContactForces to_message(const ContactReport& report) {
  lattice_impact::ContactForces message;
  to_message(report, message);
  return message;
}

void to_message(const ContactReport& report, lattice_impact::ContactForces& message) {
  message.step = report.step;
  message.time = report.time;
  for (auto* column : {&message.fx, &message.fy, &message.sample_time, &message.sample_force}) {
    column->clear();
  }
  message.point.clear();
  for (const PointForce& contact : report.points) {
    message.point.push_back(static_cast<std::uint32_t>(contact.point));
    message.fx.push_back(contact.force.x());
    message.fy.push_back(contact.force.y());
  }
  message.total_x = report.total.x();
  message.total_y = report.total.y();
  message.impulse = report.impulse;
  message.peak_force = report.peak_force;
  for (const ForceSample& sample : report.samples) {
    message.sample_time.push_back(sample.time);
    message.sample_force.push_back(sample.force);
  }
}

lattice_impact::EnergyLedger to_message(const EnergyLedger& ledger, double error) {
  lattice_impact::EnergyLedger message;
  copy_energies(ledger, error, message);
  return message;
}

lattice_impact::Scalars to_message(const BodyMotion& motion, const ContactReport& report,
                                   const EnergyLedger& ledger, double error) {
  lattice_impact::Scalars message;
  message.step = report.step;
  message.time = report.time;
  message.x = motion.centre.x();
  message.y = motion.centre.y();
  message.vx = motion.velocity.x();
  message.vy = motion.velocity.y();
  message.spin = motion.spin();
  message.force_x = report.total.x();
  message.force_y = report.total.y();
  copy_energies(ledger, error, message);
  return message;
}

lattice_impact::Strain to_message(const Strain& strain) {
  lattice_impact::Strain message;
  message.height = strain.height;
  message.reference_height = strain.reference_height;
  message.strain = strain.strain();
  message.strain_from_radius = strain.strain_from_radius();
  message.rotation = strain.rotation;
  return message;
}

lattice_impact::Restitution to_message(const Restitution& restitution) {
  lattice_impact::Restitution message;
  message.velocity_before = restitution.velocity_before;
  message.tangential_velocity_before = restitution.tangential_velocity_before;
  message.spin_before = restitution.spin_before;
  message.velocity_after = restitution.velocity_after;
  copy_numbers(restitution, message);
  return message;
}

lattice_impact::ImpactNumbers numbers_to_message(const Restitution& restitution) {
  lattice_impact::ImpactNumbers message;
  copy_numbers(restitution, message);
  return message;
}

lattice_impact::LawFit to_message(const LawFit& law) {
  lattice_impact::LawFit message;
  message.law = law.law;
  for (const MeanPoint& point : law.points) {
    message.x.push_back(point.x);
    message.y.push_back(point.y);
    message.y_standard_error.push_back(point.standard_error);
    message.runs.push_back(static_cast<std::uint32_t>(point.runs));
  }
  message.y_theory = law.theory;
  message.y_inertial_load = law.inertial_load;
  for (const LawFit::Parameter& parameter : law.parameters) {
    message.names.push_back(parameter.name);
    message.values.push_back(parameter.estimate.value);
    message.standard_errors.push_back(parameter.estimate.standard_error);
    message.paper_values.push_back(parameter.paper);
  }
  message.declined = law.fit.declined;
  const bool fitted = law.fit.declined.empty();
  message.residual = fitted ? law.fit.residual : LawFit::kNaN;
  message.x_low = fitted ? law.fit.x_low : LawFit::kNaN;
  message.x_high = fitted ? law.fit.x_high : LawFit::kNaN;
  return message;
}

Lattice from_message(const lattice_impact::Lattice& message) {
  require_equal("Lattice", {message.x.size(), message.y.size()});
  require_equal("Lattice", {message.bond_first.size(), message.bond_second.size(),
                            message.natural_length.size()});
  Lattice lattice{points(message.x, message.y), {}, message.natural_length};
  for (std::size_t k = 0; k < message.bond_first.size(); ++k) {
    if (std::max(message.bond_first[k], message.bond_second[k]) >= message.x.size()) {
      throw std::runtime_error("Lattice: a bond names a point that is not there");
    }
    lattice.bonds.push_back({static_cast<std::int32_t>(message.bond_first[k]),
                             static_cast<std::int32_t>(message.bond_second[k])});
  }
  return lattice;
}

State from_message(const lattice_impact::ParticleStates& message) {
  require_equal("ParticleStates",
                {message.x.size(), message.y.size(), message.vx.size(), message.vy.size()});
  return {message.time, message.step, points(message.x, message.y), points(message.vx, message.vy)};
}

ContactReport from_message(const lattice_impact::ContactForces& message) {
  require_equal("ContactForces", {message.point.size(), message.fx.size(), message.fy.size()});
  require_equal("ContactForces", {message.sample_time.size(), message.sample_force.size()});
  ContactReport report;
  report.time = message.time;
  report.step = message.step;
  for (std::size_t k = 0; k < message.point.size(); ++k) {
    report.points.push_back(
        {static_cast<std::int32_t>(message.point[k]), {message.fx[k], message.fy[k]}});
  }
  report.total = {message.total_x, message.total_y};
  report.impulse = message.impulse;
  report.peak_force = message.peak_force;
  for (std::size_t k = 0; k < message.sample_time.size(); ++k) {
    report.samples.push_back({message.sample_time[k], message.sample_force[k]});
  }
  return report;
}

}  // namespace impact
