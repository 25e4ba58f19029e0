#pragma once

#include <memory>

#include "mechanics/motion.hpp"
#include "mechanics/velocity_verlet.hpp"

namespace impact {

/// A motion that goes on by itself.
///
/// Where the field has a velocity reset, it acts at the end of each step that completes its
/// interval.
class Simulation : public Motion {
 public:
  /// `step` in R/c. It must be stable for the spectrum, see StepBound::step_limit(), and divide
  /// the interval of a velocity reset. An integrator that chooses steps by itself goes from one
  /// multiple of `step` to the next.
  Simulation(ForceField field, State initial, const Spectrum& spectrum, double step,
             std::unique_ptr<Integrator> integrator = std::make_unique<VelocityVerlet>());

  void step();

 protected:
  std::unique_ptr<Integrator> integrator_;

 private:
  double approach_speed() const;
  void reset_velocities();
};

}  // namespace impact
