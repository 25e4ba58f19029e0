#pragma once

#include <memory>
#include <optional>

#include "mechanics/body_motion.hpp"
#include "mechanics/potential_wall.hpp"
#include "mechanics/system.hpp"
#include "run/bodies.hpp"
#include "scene/scene.hpp"
#include "statics/tethers.hpp"

namespace impact {

/// What is known of a disk that flies away from a flat wall.
struct Flight {
  double height;             ///< of the centre of mass above the wall's surface, R
  double velocity;           ///< of the centre of mass away from the surface, c
  double angle;              ///< by which the reference lattice is turned, rad
  double counter_clockwise;  ///< the greatest spin in this direction, at least 0, c/R
  double clockwise;          ///< the same in the other
  double swing;              ///< how far a point may come out of the turned reference lattice, R
};

/// What a wall does to a disk above it.
struct WallAbove {
  PotentialWall law;
  double threshold = 0.0;  ///< gap from which on nothing is felt, R
  double limit = 0.0;      ///< energy that counts as none, M c²
};

/// Whether the wall's energy stays below the limit. The lattice cannot be turned by the angle φ
/// before the time φ/spin. So it is enough to show, for all angles up to one turn in each
/// direction, that the turned reference lattice (about its centre of mass) has less energy when
/// raised by velocity · φ/spin and lowered by the swing. Per rad, no height changes by more than
/// the distance of the outermost point from the centre of mass; this sets the steps of the angle.
/// Also false if 200 steps do not decide.
bool stays_above(const PointArray& reference, const Flight& flight, const WallAbove& wall);

/// What is left of a disk's motion besides the velocity of its centre of mass.
struct InnerMotion {
  double energy;            ///< kinetic and bond energy in the frame of the centre of mass, M c²
  double angular_momentum;  ///< M c R
};

/// Bounds of the motion of a free disk, for all time.
struct InnerBounds {
  bool hold;                 ///< false: too much energy for the bounds of first order
  double counter_clockwise;  ///< as in Flight
  double clockwise;
  double swing;
};

/// Whether a disk that flies away from the wall can reach it again.
///
/// Free of the wall, the centre of mass keeps its velocity V, and the energy E in its frame does
/// not grow. The disk is its reference lattice, turned by the angle θ of the best fit, and
/// displacements u from there.
///   U = E − L²/(2 I), without damping, is what bonds can hold, since the angular momentum L is
///     constant; with damping it is E.
///   u = √(2 U C/k_a) with the largest compliance C of a point.
///   |dθ/dt| ≤ (|L| + U/ω₁)/I without damping, since displacements of frequencies from ω₁ on carry
///     an angular momentum of at most U/ω₁; the sign is that of L where |L| is the greater part.
///     With damping, where L is not constant, it is √(2 E/I) in both directions.
///   √I lies within √(2 U)/ω₁ of that of the reference lattice.
/// The compliance and ω₁ are of first order in the strain (see Flexibility). With the elongation
/// X = √(2 U/k_a) of a bond that holds all of U, and the spacing s = √(π/N) R, u has a margin of
/// X/s of itself for the second order; U has one of 10 % for the energy's oscillation in steps of
/// time. Where X exceeds s/3, or the lattice is folded, only the lengths of bonds bound where
/// points are, however the disk turns: see Tethers.
///
/// The surface of an elastic wall rises, too, by its energy E_w, which does not grow:
///   with a clamped boundary by 2 √(2 E_w C_w/k_a), twice since the clamps move where the wall is
///     fitted best, and at most by half its length, as the chain of bonds allows;
///   else from where the wall fits best by √(2 E_w C_w/k_a), and with the speed that a rigid motion
///     of the energy E_w gives to its ends; or, where X exceeds s, as its tethers allow. A wall
///     that has folded keeps energy for good. Where its kinetic energy is below 10⁻⁶ of E_w at two
///     looks in a row, it rests, and twice that kinetic energy is taken for what moves it about its
///     present shape. This is not a proof.
/// Gaps perpendicular to the surface are taken as 0.9 of the vertical ones, which holds for slopes
/// up to 0.48.
class FreeFlight {
 public:
  FreeFlight(Scene scene, std::shared_ptr<const Bodies> bodies);

  /// Whether the wall's energy will stay below this fraction of M V²/2. False if the disk does not
  /// fly away, or if that cannot be shown.
  bool is_for_good(const System& system, double fraction);

  InnerBounds bounds(const InnerMotion& motion) const;

 private:
  /// Of the surface of the wall: its greatest height now, and the speed with which it may rise.
  struct Surface {
    double height;
    double speed;
  };
  Surface surface(const System& system, double energy);
  Surface clamped_surface(double elongation) const;
  Surface free_surface(const PointArray& shape, const ConstPoints& position, double energy);
  bool wall_rests(const System& system, double energy);
  static double elongation(double energy, const Scene::Material& material);
  /// How far a point of this body may come out of place (R), X being the elongation.
  double swing(const Flexibility& body, double elongation) const;
  WallAbove wall_above(const System& system, double limit) const;

  Scene scene_;
  std::shared_ptr<const Bodies> bodies_;
  PointArray reference_;  ///< about its centre of mass
  double inertia_;
  double spacing_;
  std::optional<Tethers> tethers_;
  std::optional<Tethers> wall_tethers_;
  bool wall_rested_ = false;  ///< at the last look
};

}  // namespace impact
