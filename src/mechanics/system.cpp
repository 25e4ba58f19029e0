#include "mechanics/system.hpp"

#include <utility>

namespace impact {

System::System(ForceField field, State initial, double step_size)
    : field_(std::move(field)), state_(std::move(initial)), step_size_(step_size) {}

double System::kinetic_energy() const {
  return 0.5 * field_.point_mass * state().velocity.square().sum();
}

double System::largest_static_force() const {
  ForceField field = field_;
  PointArray force(state().position.rows(), 2);
  field.evaluate_undamped(state().position, force);
  return force.abs().maxCoeff();
}

}  // namespace impact
