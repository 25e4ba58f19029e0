#include "run/energy_monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace impact {
namespace {

double active_energy(const EnergyLedger& ledger) {
  return ledger.kinetic() + ledger.bonds + ledger.wall + ledger.wall_lattice;
}

}  // namespace

EnergyMonitor::EnergyMonitor(const EnergyLedger& start)
    : total_at_start_(start.total()), largest_energy_(active_energy(start)) {}

void EnergyMonitor::check(const System& system) {
  const EnergyLedger ledger = system.ledger();
  const double deviation = std::abs(ledger.total() - total_at_start_);
  if (!(deviation <= std::max(largest_energy_, ledger.dissipated + ledger.absorbed))) {
    const std::string total = std::isfinite(ledger.total())
                                  ? fmt::format("total {:.3g}", ledger.total())
                                  : "total no longer finite";
    throw RunFailure(fmt::format(
        "the energy balance broke at t = {:.6g} R/c ({}, at the start {:.3g} M c²): with steps of "
        "{:.3g} R/c the integrator does not hold the motion",
        system.time(), total, total_at_start_, system.step_size()));
  }
  largest_deviation_ = std::max(largest_deviation_, deviation);
  largest_energy_ = std::max(largest_energy_, active_energy(ledger));
}

bool EnergyMonitor::is_alarming(const System& system) const {
  return !(system.kinetic_energy() <= 2.0 * largest_energy_);
}

}  // namespace impact
