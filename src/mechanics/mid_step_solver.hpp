#pragma once

#include <optional>

#include "kernels/panel_cholesky.hpp"
#include "mechanics/force_field.hpp"

namespace impact {

/// Solves
///   A u = (1 + h D/2m + h² K/4m) u = b
/// for the velocities u of all points, in the frame that turns with the lattice, with
///   D = η L, the damping matrix of the bonds, L the Laplacian matrix of their graph, for x and y,
///   K = k_a P L P, P the projection that takes rigid rotation out.
/// K bounds the stiffness of the unstrained bonds from above: what a bond resists along its
/// direction it resists in K in all, while neither resists a rigid motion. So x and y have one
/// Cholesky factor, of B = 1 + c L with c = h η/2m + h² k_a/4m. P is a correction of rank 2: with r
/// the velocities of a rigid rotation, z = B⁻¹ r, q = r − z |r|²/r·z, g = h η/2mc and p = r − g q,
///   A⁻¹ = B⁻¹ − z zᵀ/r·z + p pᵀ/p·A r.
///
/// The mean velocity, which the matrix leaves as it is, does not go through the factor, since
/// rounding would make relative velocities of it, c |L| spacings of doubles large. Rotation is so
/// small in s = B⁻¹ b that p restores it to rounding.
///
/// Where the field holds the rotation, u keeps the constraint.
class MidStepSolver {
 public:
  /// @throw std::invalid_argument where the field does not know its unstrained positions, or has
  /// bonds of two laws or supports.
  explicit MidStepSolver(const ForceField& field);

  /// Factorises for this step (R/c), unless it has done so last.
  void prepare(double h);

  /// Overwrites b with u, and `differences` with L u, of each point the sum of its velocities
  /// relative to those that it has bonds with; without its torque where the rotation is held.
  void solve(PointArray& velocity, PointArray& differences);

  /// Unstrained positions about their centre of mass, and the same turned by a right angle: r.
  const PointArray& arm() const { return arm_; }
  const PointArray& rotation() const { return rotation_->direction(); }

 private:
  /// L x.
  PointArray laplacian_of(const PointArray& x);

  BondForces differences_of_;  ///< of unit viscosity
  BondLaw law_;
  double point_mass_;
  bool is_held_;
  double step_ = 0.0;
  PointArray arm_;
  std::optional<RotationHold> rotation_;

  double coupling_ = 0.0;  ///< c
  std::optional<PanelCholesky> factor_;
  PointArray held_response_;        ///< z
  PointArray held_differences_;     ///< L z
  double held_share_ = 0.0;         ///< 1/r·z
  PointArray turning_response_;     ///< p
  PointArray turning_differences_;  ///< L p
  double turning_share_ = 0.0;      ///< 1/p·A r; 0 where the rotation is held
};

}  // namespace impact
