#pragma once

#include <memory>

#include "mechanics/motion.hpp"
#include "run/compose.hpp"
#include "scene/scene.hpp"

namespace impact {

/// Knows when the question of a run is answered. Asked after every step, so that the end does not
/// depend on the output period.
class EndOfRun {
 public:
  virtual ~EndOfRun() = default;
  virtual bool reached(const Motion& motion) = 0;
  /// The flag of a run that is given up before its end is reached.
  virtual const char* flag_if_given_up() const = 0;
};

/// The disk has left the wall for good: the wall has held more than the negligible energy, has
/// held less for a time of 5 R/c_s, longer than the period of the disk's slowest vibration, and
/// the centre of mass moves away.
class SeparationEnd : public EndOfRun {
 public:
  SeparationEnd(double negligible_energy, double sound_speed);
  bool reached(const Motion& motion) override;
  const char* flag_if_given_up() const override { return "not_separated"; }

 private:
  double negligible_energy_;
  double waiting_time_;
  bool touched_ = false;
  double last_touch_ = 0.0;
};

/// The disk rests. Looked at once every R/c: no component of the static force on any point exceeds
/// negligible_static_force(), and no component of a velocity error/10 of P/√(M k_a), or 4 ε R/h,
/// which moves nothing in a step of h (ε: spacing of doubles).
class RestEnd : public EndOfRun {
 public:
  RestEnd(const Scene& scene, Eigen::Index points, double step);
  bool reached(const Motion& motion) override;
  const char* flag_if_given_up() const override { return "not_at_rest"; }

 private:
  double largest_force_;
  double largest_speed_;
  double next_look_ = 0.0;
};

/// A static solution without motion is an end by itself.
class StaticEnd : public EndOfRun {
 public:
  bool reached(const Motion& /*motion*/) override { return true; }
  const char* flag_if_given_up() const override { return "not_at_rest"; }
};

/// The largest component of a static force (M c²/R) that counts as none. In a stretch scene
/// error/100 of what a bond of the typical length √(π/N) R carries; in a contact scene error/10 of
/// P/N, but no less than what rounding leaves: 2·10⁻¹⁵ k_a R of the bonds and, where a motion in
/// steps of h (R/c) comes to rest, 12 η ε R/h. There the damping, whose Laplacian has the largest
/// eigenvalue 12, makes the displacement of a step smaller than the spacing ε of doubles.
double negligible_static_force(const Scene& scene, Eigen::Index points, double step);

/// `step` in R/c.
std::unique_ptr<EndOfRun> end_of_run(const Scene& scene, const Composition& composition,
                                     double step);

}  // namespace impact
