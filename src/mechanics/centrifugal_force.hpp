#pragma once

#include "mechanics/force_term.hpp"

namespace impact {

/// What the points of a body feel at rest in a frame that turns with it about its centre of mass:
/// m ω² (r − r_cm), with the potential −m ω²/2 Σ |r − r_cm|². An equilibrium under it is the shape
/// of a body that spins steadily. It has no resultant and no torque. Its stiffness is left out: −m
/// ω², far less than that of the bonds.
class CentrifugalForce : public ForceTerm {
 public:
  static constexpr const char* kName = "centrifugal force";

  /// `spin` ω in c/R, `point_mass` m in M.
  CentrifugalForce(double spin, double point_mass) : factor_(point_mass * spin * spin) {}

  void add_forces(const PointArray& position, PointArray& force) const {
    force += factor_ * (position.rowwise() - position.colwise().mean());
  }
  void enter(const PointArray& position, EnergyLedger& ledger) const {
    ledger.load -= 0.5 * factor_ * (position.rowwise() - position.colwise().mean()).square().sum();
  }

 private:
  double factor_;  ///< M c²/R²
};

}  // namespace impact
