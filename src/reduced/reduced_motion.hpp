#pragma once

#include <memory>
#include <vector>

#include "mechanics/system.hpp"
#include "reduced/quasi_static_contact.hpp"

namespace impact {

/// A slow impact of an undamped disk on the potential wall, of which only the rigid motion takes
/// time: centre of mass and angle, in the potential U(Y, φ) of a QuasiStaticContact. What vibrates
/// is left out, and so is what the elastic displacement changes of the moment of inertia.
///
/// Velocity Verlet with V = dY/dt, ω = dφ/dt, M = 1 and the moment of inertia I:
///   (V, ω) += h/2 (−∂U/∂Y, −∂U/∂φ/I), (Y, φ) += h (V, ω), (V, ω) += h/2 (…).
/// Positions and velocities of all points are worked out when somebody asks for the state.
class ReducedMotion : public System {
 public:
  static constexpr int kOrder = 2;

  /// Of a field of bonds and a potential wall, the lattice in its reference configuration at the
  /// start, not turned. A point whose energy on the wall is below `negligible_energy` (M c²) is not
  /// in contact. `step` in R/c.
  ReducedMotion(ForceField field, State initial, std::shared_ptr<Compliance> compliance,
                double negligible_energy, double step);

  void step();

  const State& state() const override;
  double kinetic_energy() const override;
  ModelError model_error() const override;

  /// Rigid kinetic energy and U, M c²: constant to the order of the method.
  double energy() const { return kinetic_energy() + contact_.energy(); }
  const Pose& pose() const { return pose_; }
  const PoseRate& rate() const { return rate_; }
  const QuasiStaticContact& contact() const { return contact_; }

 private:
  void kick(double time);
  void take_pose();
  void recover() const;

  double inertia_;   ///< M R²
  double x_;         ///< of the centre of mass at the start, R
  double sideways_;  ///< c
  Pose pose_;
  PoseRate rate_;
  double speed_before_;  ///< along y, c
  QuasiStaticContact contact_;
  std::vector<Pose> poses_;     ///< at all steps
  std::vector<double> spins_;   ///< half a step before each, c/R
  std::vector<double> forces_;  ///< at each, M c²/R
  mutable bool is_current_ = true;
};

}  // namespace impact
