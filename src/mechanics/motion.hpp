#pragma once

#include <cstdint>

#include "mechanics/integrator.hpp"
#include "mechanics/spectrum.hpp"
#include "mechanics/system.hpp"

namespace impact {

/// A system in motion.
///
/// The wall grows stiffer the deeper a point is pressed into it. So the integrator's stability
/// bound is checked before each step, with the stiffness a F of the largest force that a point may
/// meet in that step, times wall_margin(): F exp(a v h), v being the greatest speed at which a
/// point of the disk and one of the wall may approach each other. While the step exceeds the bound,
/// it is halved for good.
class Motion : public System {
 public:
  /// Times the stiffness of the wall: for what the force may grow beyond the forecast. None where
  /// the method solves for the bonds: that adds to the inertia of the points.
  static constexpr double wall_margin(bool solves_for_bonds) {
    return solves_for_bonds ? 1.0 : 1.5;
  }
  /// How deep below the outline of a body points count as outer ones, in spacings.
  static constexpr double kDepthOfOuterPoints = 0.5;
  /// Mean spacing of so many points of a disk, √(π/N) R.
  static double spacing(Eigen::Index points);
  /// Of the force on an outer point, what an inner one may meet: exp(−a depth).
  static double inner_share(double a, double spacing);

 protected:
  Motion(ForceField field, State initial, const Spectrum& spectrum, double step);

  /// Halves the step until it is stable. `approach`: speed (c) of wall and disk towards each other.
  void limit_step(const Contact& wall, double approach, const StepBound& bound);
  void count_step(const Losses& lost);
  /// Whether the step that was counted last completes an interval of the field's velocity reset.
  bool reset_is_due() const;

  Spectrum spectrum_;
  double inner_share_ = 1.0;
  std::uint64_t ticks_ = 0;  ///< time in units of the present step
};

}  // namespace impact
