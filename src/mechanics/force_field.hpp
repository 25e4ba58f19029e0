#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mechanics/bond_forces.hpp"
#include "mechanics/compression_load.hpp"
#include "mechanics/potential_wall.hpp"
#include "mechanics/rotation_hold.hpp"

namespace impact {

/// All that acts on the points of one scene: its bonds and, only if the scene has them, a wall, a
/// load and a constraint.
struct ForceField {
  BondForces bonds;
  double point_mass = 1.0;  ///< M
  std::optional<PotentialWall> wall{};
  std::optional<CompressionLoad> load{};
  std::optional<RotationHold> hold{};

  /// Overwrites `force` (M c²/R, one row a point) with the total force on each point. Returns the
  /// power dissipated by damping (M c³/R).
  double evaluate(const PointArray& position, const PointArray& velocity, PointArray& force);

  /// Of bonds, wall and load, in M c².
  double potential_energy(const PointArray& position) const;

  /// Names of the terms that are evaluated.
  std::vector<std::string> terms() const;
};

}  // namespace impact
