#pragma once

#include <memory>

#include "mechanics/system.hpp"
#include "reduced/modal_correction.hpp"

namespace impact {

/// A slow impact of a disk on the potential wall, damped or not, in the modes of its bulk: see
/// ModalDynamics. Positions and velocities of all points are worked out when somebody asks for the
/// state.
///
/// The step is halved for good where the stiffness that the wall may reach in it, as a Motion
/// forecasts it, exceeds 4 m/h².
class ModalMotion : public System {
 public:
  static constexpr int kOrder = 2;

  /// Of a field of bonds and a potential wall, the lattice in its reference configuration at the
  /// start, not turned. The correction is taken `delay` (R/c) later. `step` in R/c.
  ModalMotion(ForceField field, State initial, const std::shared_ptr<const BulkModes>& modes,
              const ModalCorrection& correction, double delay, double step);

  void step();

  const State& state() const override;
  double kinetic_energy() const override;
  ModelError model_error() const override { return left_out_; }

  const ModalDynamics& dynamics() const { return dynamics_; }

 private:
  void take_force();
  void limit_step();
  void recover() const;

  double x_;         ///< of the centre of mass at the start, R
  double sideways_;  ///< c
  ModelError left_out_;
  ModalDynamics dynamics_;
  mutable bool is_current_ = true;
};

}  // namespace impact
