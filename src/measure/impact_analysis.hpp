#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "measure/contact_report.hpp"
#include "measure/contact_time.hpp"
#include "mechanics/body_motion.hpp"

namespace impact {

/// What an impact did to the disk; NaN for what is not known yet. Where it met other disks,
/// velocities are as seen from the common centre of mass, and energies are those of all.
struct Restitution {
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  double velocity_before = kNaN;             ///< of the centre of mass along y, c
  double tangential_velocity_before = kNaN;  ///< of the centre of mass along x, c
  double spin_before = kNaN;                 ///< as spin_after, c/R
  double moment_of_inertia = kNaN;           ///< about the centre of mass, at the start, M R²
  double energy_before = kNaN;               ///< of the rigid motion at the start, M c²
  double velocity_after = kNaN;              ///< of the centre of mass along y, c
  /// e = −velocity_after/velocity_before. Where the disk met others, that is as well the velocity
  /// at which it leaves their common centre of mass over that at which it came to it.
  double restitution = kNaN;
  double tangential_velocity_after = kNaN;  ///< of the centre of mass along x, c
  /// Counter-clockwise, c/R: the angular momentum over the moment of inertia at the start, so that
  /// the disk's vibrations do not show.
  double spin_after = kNaN;
  /// √(E′/E), E of the rigid motion: translation and rotation. Unlike e it counts an impact that
  /// only turns the disk as one without loss.
  double energy_restitution = kNaN;
  double contact_begin = kNaN;     ///< R/c
  double contact_end = kNaN;       ///< R/c
  double contact_duration = kNaN;  ///< R/c
  double peak_force = kNaN;        ///< M c²/R
  double impulse = kNaN;           ///< of the wall along y, M c
  /// β = −g′/g, g = v_x + ω R the velocity along the wall of the disk's surface above the wall, or
  /// along the top of the other disk and less that of it: −1 where it slides on, 1 where it turns
  /// back. NaN where g was zero.
  double tangential_restitution = kNaN;
  /// The change of the momentum along x over that along y: what friction would have as its
  /// coefficient.
  double impulse_ratio = kNaN;
  /// The parts of E′/E, E as in energy_restitution: of the motion along y, along x and of the spin.
  double normal_energy = kNaN;
  double tangential_energy = kNaN;
  double rotation_energy = kNaN;
  /// Of the disks that were met, one below another: velocities of the centre of mass along y and x
  /// (c), and the spin as spin_after.
  double wall_velocity_after = kNaN;
  double wall_tangential_velocity_after = kNaN;
  double wall_spin_after = kNaN;
  double wall2_velocity_after = kNaN;
  double wall2_tangential_velocity_after = kNaN;
  double wall2_spin_after = kNaN;
  double wall3_velocity_after = kNaN;
  double wall3_tangential_velocity_after = kNaN;
  double wall3_spin_after = kNaN;
  /// Of several disks that were met: the momentum along y that the last one took over, in parts of
  /// that of the first one as seen by the last one at the start.
  double momentum_passed_on = kNaN;
  /// The same: −u′/u, u the velocity along y of the first disk as seen by the last one.
  double restitution_of_ends = kNaN;
};

/// Takes the states and contact reports of one run, each in the order of time, and says what the
/// impact did. Only the first and the last state and the force at every step count, so that the
/// answer does not depend on how often states are given.
class ImpactAnalysis {
 public:
  /// Where gravity (c²/R) pulls the disk down, its velocities before and after are those which it
  /// has, in free flight, at the height at which it touches: where its lowest point at the start
  /// would be at y = 0.
  explicit ImpactAnalysis(double gravity = 0.0) : gravity_(gravity) {}

  /// Of the disk and of those bodies that it meets and that are free, as it is; the last one last.
  void add(const State& state, const std::vector<State>& others = {});
  /// The same of a disk of which no more is known, at a wall and without gravity.
  void add(const BodyMotion& motion);
  void add(const ContactReport& report);

  /// `separated`: the last state given is one after the disk has left for good.
  Restitution restitution(bool separated) const;

 private:
  struct Other {
    BodyMotion motion;
    double mass = 0.0;  ///< M
  };
  struct Motions {
    BodyMotion first;
    std::vector<Other> others;
  };
  struct Shares {
    double normal;
    double tangential;
    double rotation;
    double sum() const { return normal + tangential + rotation; }
  };
  Shares shares(const Motions& motions) const;
  double sliding(const Motions& motions) const;
  void say_before(Restitution& result) const;
  void say_after(Restitution& result) const;
  void say_of_others(Restitution& result) const;
  BodyMotion where_it_touches(BodyMotion motion) const;

  double gravity_;
  double touching_height_ = 0.0;  ///< of the centre of mass, R
  std::optional<Motions> before_;
  Motions latest_;
  double radius_of_touched_ = 0.0;  ///< R, from its centre of mass to where the disk touches it
  ContactTime contact_;
  std::optional<ForceSample> last_sample_;
  double impulse_ = 0.0;
};

}  // namespace impact
