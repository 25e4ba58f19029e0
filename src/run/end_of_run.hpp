#pragma once

#include <limits>
#include <memory>

#include "measure/flags.hpp"
#include "mechanics/system.hpp"
#include "run/compose.hpp"
#include "run/free_flight.hpp"
#include "scene/scene.hpp"

namespace impact {

/// Knows when the question of a run is answered. Asked after every step, so that the end does not
/// depend on the output period, or once after a search for the static solution.
class EndOfRun {
 public:
  virtual ~EndOfRun() = default;
  virtual bool reached(const System& system) = 0;
  /// The flag of a run that is given up before its end is reached.
  virtual Flag flag_if_given_up() const = 0;
  /// Of the energy along y: what a contact may hold after the end, as far as it is known.
  virtual double remaining_energy() const { return std::numeric_limits<double>::infinity(); }
  /// Extra time (R/c) that the end may take although the run is going well.
  virtual double time_under_way() const { return 0.0; }
};

/// The disk has left what it met for good: the contact has held more than the negligible energy of
/// expected_time.hpp, and from now on its energy cannot exceed remaining_fraction() of that of the
/// centre of mass, which moves away (see FreeFlight). Looked at every 16 steps.
class SeparationEnd : public EndOfRun {
 public:
  SeparationEnd(const Scene& scene, const Composition& composition);
  bool reached(const System& system) override;
  Flag flag_if_given_up() const override { return Flag::kNotSeparated; }
  /// The time for 10 R at the smallest velocity that the disk had between its touches, or at 10⁻³
  /// of that before.
  double time_under_way() const override { return time_under_way_; }
  double remaining_energy() const override { return remaining_; }

 private:
  double velocity_before_;
  double negligible_energy_;
  double remaining_;  ///< the most that may remain; at the end, what may
  FreeFlight flight_;
  bool touched_ = false;
  double time_under_way_ = 0.0;
};

/// The disk rests. Looked at once every R/c: no component of the static force on any point exceeds
/// negligible_static_force(), and no component of a velocity error/10 of P/√(M k_a), or 4 ε R/h,
/// which moves nothing in a step of h (ε: spacing of doubles).
class RestEnd : public EndOfRun {
 public:
  RestEnd(const Scene& scene, Eigen::Index points, double step);
  bool reached(const System& system) override;
  Flag flag_if_given_up() const override { return Flag::kNotAtRest; }

 private:
  double largest_force_;
  double largest_speed_;
  double next_look_ = 0.0;
};

/// The static solution is found: no component of the static force on any point exceeds
/// negligible_static_force().
class StaticEnd : public EndOfRun {
 public:
  explicit StaticEnd(double largest_force) : largest_force_(largest_force) {}
  bool reached(const System& system) override {
    return system.largest_static_force() <= largest_force_;
  }
  Flag flag_if_given_up() const override { return Flag::kNotAtRest; }

 private:
  double largest_force_;
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
