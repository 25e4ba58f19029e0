#pragma once

#include <cstdint>

#include "mechanics/energy_ledger.hpp"
#include "mechanics/force_field.hpp"
#include "mechanics/model_error.hpp"
#include "mechanics/state.hpp"

namespace impact {

/// Points and the forces on them, which go on in steps: of time in a Motion, of Newton's method in
/// an EquilibriumSearch. What an observer sees of both.
class System {
 public:
  virtual ~System() = default;

  virtual const State& state() const { return state_; }
  double time() const { return state_.time; }          ///< of the state, R/c
  std::uint64_t steps() const { return state_.step; }  ///< of the state
  const ForceField& field() const { return field_; }
  /// R/c; of a search 1, as which an iteration counts.
  double step_size() const { return step_size_; }
  /// How many times the step was halved.
  int halvings() const { return halvings_; }
  /// What contacts were forecast to add at most to the square of a frequency, in steps as long as
  /// the first one (c²/R²).
  double stiffest_contact() const { return stiffest_contact_; }

  virtual double kinetic_energy() const;  ///< of all points, M c²
  virtual ModelError model_error() const { return {}; }
  EnergyLedger ledger() const { return field_.ledger(state(), losses_); }

  /// Largest component, over all points, of the force on a point at rest in the present
  /// configuration, in M c²/R.
  double largest_static_force() const;

 protected:
  System(ForceField field, State initial, double step_size);

  ForceField field_;
  mutable State state_;  ///< while in a lane, with positions and velocities of an earlier step
  double step_size_;
  int halvings_ = 0;
  double stiffest_contact_ = 0.0;
  Losses losses_;
};

}  // namespace impact
