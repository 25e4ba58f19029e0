#pragma once

#include <limits>
#include <optional>

#include "measure/contact_report.hpp"
#include "measure/contact_time.hpp"
#include "mechanics/body_motion.hpp"

namespace impact {

/// What an impact did to the disk; NaN for what is not known yet. Where it met another disk,
/// velocities are as seen from the common centre of mass, and energies are those of both.
struct Restitution {
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  double velocity_before = kNaN;             ///< of the centre of mass along y, c
  double tangential_velocity_before = kNaN;  ///< of the centre of mass along x, c
  double spin_before = kNaN;                 ///< as spin_after, c/R
  double moment_of_inertia = kNaN;           ///< about the centre of mass, at the start, M R²
  double energy_before = kNaN;               ///< of the rigid motion at the start, M c²
  double velocity_after = kNaN;              ///< of the centre of mass along y, c
  double restitution = kNaN;                 ///< e = −velocity_after/velocity_before
  double tangential_velocity_after = kNaN;   ///< of the centre of mass along x, c
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

  void add(const State& state);
  /// Of a disk and of another one that it meets.
  void add(const State& state, const State& second);
  void add(const ContactReport& report);

  /// `separated`: the last state given is one after the disk has left for good.
  Restitution restitution(bool separated) const;

 private:
  struct Motions {
    BodyMotion first;
    std::optional<BodyMotion> second;  ///< of a body that is free too
    double second_mass = 0.0;          ///< M
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
  BodyMotion where_it_touches(BodyMotion motion) const;

  double gravity_;
  double touching_height_ = 0.0;  ///< of the centre of mass, R
  std::optional<Motions> before_;
  Motions latest_;
  double second_radius_ = 0.0;  ///< R, from the centre of mass to where it is touched
  ContactTime contact_;
  std::optional<ForceSample> last_sample_;
  double impulse_ = 0.0;
};

}  // namespace impact
