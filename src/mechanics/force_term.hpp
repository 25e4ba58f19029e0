#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <string>
#include <vector>

#include "lattice/lattice.hpp"
#include "mechanics/energy_ledger.hpp"
#include "mechanics/losses.hpp"

namespace impact {

/// Entries of a matrix, those of one place to be added up.
using MatrixEntries = std::vector<Eigen::Triplet<double>>;

/// What a term of a ForceField says of itself: nothing, where a term does not hide it. Forces are
/// in M c²/R, positions in R, one row a point. No call is virtual: the field knows its terms by
/// type.
struct ForceTerm {
  /// Whether forces depend on velocities.
  static constexpr bool kIsDamping = false;
  /// Whether LaneField takes it over, by a take() of its own.
  static constexpr bool kInLanes = false;

  /// Adds the forces on points at rest.
  void add_forces(const PointArray& /*position*/, PointArray& /*force*/) {}
  /// Adds the forces that depend on velocities. Returns the powers that they take away.
  static Losses add_damping_forces(const PointArray& /*velocity*/, PointArray& /*force*/) {
    return {};
  }
  /// Takes away what would break a constraint, after all forces were added.
  void constrain(PointArray& /*force*/) {}

  /// Adds to the tangent stiffness matrix −∂F/∂r (M c²/R²); row and column i stand for x of point
  /// i, N + i for its y.
  void add_stiffness(const PointArray& /*position*/, MatrixEntries& /*entries*/) const {}
  /// Uncouples what is held from the rest of the stiffness of so many points.
  void constrain_stiffness(std::size_t /*points*/, MatrixEntries& /*entries*/) const {}
  /// Adds to the matrix D of the damping forces −D v along one axis (0: x, 1: y), in M c/R.
  void add_damping(int /*axis*/, MatrixEntries& /*entries*/) const {}
  /// Takes away what is held from that matrix.
  void constrain_damping(int /*axis*/, MatrixEntries& /*entries*/) const {}

  /// Whether forces stay the same when everything is shifted along this axis.
  static bool shifts_freely(int /*axis*/) { return true; }
  /// Adds its energies to the ledger.
  void enter(const PointArray& /*position*/, EnergyLedger& /*ledger*/) const {}
};

}  // namespace impact
