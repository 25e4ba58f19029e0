#pragma once

#include <lattice_impact/ContactForces.h>
#include <lattice_impact/EnergyLedger.h>
#include <lattice_impact/ImpactNumbers.h>
#include <lattice_impact/Lattice.h>
#include <lattice_impact/LawFit.h>
#include <lattice_impact/ParticleStates.h>
#include <lattice_impact/Restitution.h>
#include <lattice_impact/Scalars.h>
#include <lattice_impact/Strain.h>
#include <ros/time.h>

#include "fits/law_fit.hpp"
#include "lattice/lattice.hpp"
#include "measure/contact_report.hpp"
#include "measure/impact_answer.hpp"
#include "measure/strain.hpp"
#include "mechanics/body_motion.hpp"
#include "mechanics/energy_ledger.hpp"
#include "mechanics/state.hpp"

/// Between the project's types and its messages, to the last bit. Header, run and sequence are left
/// to the caller.
namespace impact {

lattice_impact::Lattice to_message(const Lattice& lattice);
lattice_impact::ParticleStates to_message(const State& state);
lattice_impact::ContactForces to_message(const ContactReport& report);
/// The same into a message whose arrays keep their memory.
void to_message(const ContactReport& report, lattice_impact::ContactForces& message);
lattice_impact::EnergyLedger to_message(const EnergyLedger& ledger, double error);
/// Step, time and force are those of `report`.
lattice_impact::Scalars to_message(const BodyMotion& motion, const ContactReport& report,
                                   const EnergyLedger& ledger, double error);
lattice_impact::Strain to_message(const Strain& strain);
lattice_impact::Restitution to_message(const Restitution& restitution);
lattice_impact::ImpactNumbers numbers_to_message(const Restitution& restitution);
/// Without the constants, which are left to the caller too.
lattice_impact::LawFit to_message(const LawFit& law);

/// @throw std::runtime_error when the arrays of the message differ in length, or a bond names a
/// point that is not there.
Lattice from_message(const lattice_impact::Lattice& message);
State from_message(const lattice_impact::ParticleStates& message);
ContactReport from_message(const lattice_impact::ContactForces& message);

/// Copies the numbers of impact_numbers(), between any two types that have them.
template <class From, class To>
void copy_numbers(const From& from, To& to) {
  const auto source = impact_numbers<From>();
  const auto target = impact_numbers<To>();
  for (std::size_t k = 0; k < source.size(); ++k) to.*(target[k].second) = from.*(source[k].second);
}

}  // namespace impact
