#pragma once

#include <cstdint>
#include <vector>

#include "lattice/lattice.hpp"

namespace impact {

/// The repulsive wall at y = 0 of eqs. (3) and (6): potential V₀ exp(−a y) and force
/// a V₀ exp(−a y) ŷ on every point. Where a y exceeds 60 a point feels nothing: the potential
/// there is below 10⁻²⁶ V₀.
class PotentialWall {
 public:
  /// `a` in 1/R, `v0` in M c².
  PotentialWall(double a, double v0) : a_(a), v0_(v0) {}

  void add_forces(const PointArray& position, PointArray& force);

  /// Total force of the last add_forces(), along y, in M c²/R.
  double total_force() const { return total_force_; }
  /// Largest force on one point in the last add_forces().
  double largest_force() const { return largest_force_; }

  /// Force on a point at this height, in M c²/R.
  double force_at(double height) const;
  /// Height at which a point feels this force, in R.
  double height_of_force(double force) const;

  double potential_energy(const PointArray& position) const;

  /// Height of the lowest point, everything moved up or down rigidly, at which the potential
  /// energy of these points is `energy` (M c²).
  double height_of_energy(const PointArray& position, double energy) const;

  /// The wall's stiffness where it exerts this force on a point: −dF/dy = a F, in M c²/R².
  double stiffness(double force) const { return a_ * force; }
  double a() const { return a_; }

 private:
  double a_;
  double v0_;
  double total_force_ = 0.0;
  double largest_force_ = 0.0;
};

}  // namespace impact
