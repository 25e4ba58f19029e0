#pragma once

#include "mechanics/force_field.hpp"
#include "mechanics/state.hpp"

namespace impact {

/// A method that moves the points of a field forward in time. It keeps what it needs of the forces
/// at the present state, so that one integrator belongs to one field and one state.
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// Takes in the initial state.
  virtual void restart(ForceField& field, const State& state) = 0;

  /// Takes in velocities that were changed from outside.
  virtual void take_velocity(ForceField& field, const State& state) = 0;

  /// Advances position and velocity by h (R/c); leaves time and step count to the caller. The last
  /// evaluation of the field is then the one at the new position. Returns the energy lost on the
  /// way (M c²).
  virtual Losses step(ForceField& field, State& state, double h) = 0;

  /// Largest stable step (R/c) for modes up to frequency² `omega_squared` (c²/R²) and damping rate
  /// up to `gamma` (c/R); infinite where stability sets none.
  virtual double step_limit(double omega_squared, double gamma) const = 0;
};

}  // namespace impact
