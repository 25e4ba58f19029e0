#pragma once

#include <stdexcept>

#include "mechanics/system.hpp"

namespace impact {

/// A run that cannot go on; `what()` is one line with the cause.
class RunFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Watches that no energy appears or disappears.
class EnergyMonitor {
 public:
  explicit EnergyMonitor(const EnergyLedger& start);

  /// @throw RunFailure when the total has changed by more than the largest energy of the bodies so
  /// far and by more than what was dissipated and absorbed, or is not finite.
  void check(const System& system);

  /// Whether the kinetic energy alone, which costs little to know, is more than twice the largest
  /// energy so far, or not finite: a reason to check.
  bool is_alarming(const System& system) const;

  /// Largest deviation of the ledger's total from the start, over the largest sum of kinetic, bond
  /// and wall energy of the bodies, of all checks so far.
  double error() const { return largest_deviation_ / largest_energy_; }

 private:
  double total_at_start_;
  double largest_energy_;
  double largest_deviation_ = 0.0;
};

}  // namespace impact
