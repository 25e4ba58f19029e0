#pragma once

#include "mechanics/force_field.hpp"
#include "mechanics/lane_field.hpp"
#include "mechanics/spectrum.hpp"
#include "mechanics/state.hpp"

namespace impact {

/// What a method says of its steps.
class StepBound {
 public:
  virtual ~StepBound() = default;

  /// Largest stable step (R/c) for modes up to frequency² `omega_squared` (c²/R²) and damping rate
  /// up to `gamma` (c/R); infinite where stability sets none.
  virtual double step_limit(double omega_squared, double gamma) const = 0;

  /// Whether contacts alone limit the step, since it solves for what the bonds do.
  virtual bool solves_for_bonds() const { return false; }

  /// The same for a lattice whose contacts are this stiff, see Spectrum::with_contacts().
  double step_limit_with(const Spectrum& lattice, double contact_rate, double inner_share) const {
    return step_limit(
        solves_for_bonds() ? contact_rate : lattice.with_contacts(contact_rate, inner_share),
        lattice.gamma);
  }
};

/// A method that moves the points of a field forward in time: of one run (ForceField), or of kLanes
/// runs side by side (LaneField), each with a step of its own. It keeps what it needs of the forces
/// at the present state, so that one integrator belongs to one field and one state.
template <class Field>
class BasicIntegrator : public StepBound {
 public:
  /// Takes in the initial state.
  virtual void restart(Field& field, const typename Field::State& state) = 0;

  /// Takes in velocities that were changed from outside.
  virtual void take_velocity(Field& field, const typename Field::State& state) = 0;

  /// Advances position and velocity by h (R/c); leaves time and step count to the caller. The last
  /// evaluation of the field is then the one at the new position. Returns the energy lost on the
  /// way (M c²).
  virtual typename Field::Losses step(Field& field, typename Field::State& state,
                                      typename Field::Step h) = 0;
};

using Integrator = BasicIntegrator<ForceField>;

/// A method of fixed step. From step to step it only keeps the forces at the present state.
template <class Field>
class FixedStepIntegrator : public BasicIntegrator<Field> {
 public:
  /// Of lanes: takes over a run from an integrator of the same kind that has it alone.
  void take_lane(int lane, const FixedStepIntegrator<ForceField>& alone) {
    force_.lane(lane) = alone.force_;
    power_.dissipated(lane) = alone.power_.dissipated;
    power_.absorbed(lane) = alone.power_.absorbed;
  }
  /// Gives it back.
  void give_lane(int lane, FixedStepIntegrator<ForceField>& alone) const {
    alone.force_ = force_.lane(lane);
    alone.power_ = {power_.dissipated(lane), power_.absorbed(lane)};
  }

 protected:
  template <class Other>
  friend class FixedStepIntegrator;

  typename Field::Points force_;
  typename Field::Losses power_;  ///< lost by that force, M c³/R
};

}  // namespace impact
