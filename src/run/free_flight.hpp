#pragma once

#include <memory>
#include <optional>

#include "mechanics/body_motion.hpp"
#include "mechanics/potential_wall.hpp"
#include "mechanics/system.hpp"
#include "run/bodies.hpp"
#include "run/free_body.hpp"
#include "run/parting_disks.hpp"
#include "scene/scene.hpp"
#include "statics/tethers.hpp"

namespace impact {

/// What is known of a disk that flies away from a flat wall.
struct Flight {
  double height;             ///< of the centre of mass above the wall's surface, R
  double velocity;           ///< of the centre of mass away from the surface, c
  double angle;              ///< by which the reference lattice is turned, rad
  double counter_clockwise;  ///< as in InnerBounds
  double clockwise;
  double swing;
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

/// Whether a disk that flies away from the wall can reach it again.
///
/// Free of the wall, the centre of mass keeps its velocity, and FreeBody bounds the rest.
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
///
/// Under gravity the flight is followed to its top: what comes after is another impact.
///
/// Disks that fly apart: see PartingDisks.
class FreeFlight {
 public:
  FreeFlight(Scene scene, std::shared_ptr<const Bodies> bodies);

  /// Below which fraction of M V²/2 the contact's energy will stay, V the velocity of the centre of
  /// mass along y, or of all disks' energy along y: `most`, or a half, a quarter, … of it as far
  /// as can be shown, 2⁻¹⁶ at the least. Infinity if the disk does not fly away, or if not even
  /// `most` can be shown.
  double energy_bound(const System& system, double most);

 private:
  /// Of the surface of the wall: its greatest height now, and the speed with which it may rise.
  struct Surface {
    double height;
    double speed;
  };
  double bound_above_wall(const System& system, double most);
  Surface surface(const System& system);
  Surface clamped_surface(double elongation) const;
  Surface free_surface(const PointArray& shape, const ConstPoints& position, double energy);
  bool wall_rests(const System& system, double energy);
  WallAbove wall_above(const System& system, double limit) const;

  Scene scene_;
  std::shared_ptr<const Bodies> bodies_;
  FreeBody disk_;
  std::optional<PartingDisks> disks_;
  double spacing_;
  std::optional<Tethers> wall_tethers_;
  bool wall_rested_ = false;  ///< at the last look
};

}  // namespace impact
