#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

#include "mechanics/force_field.hpp"

namespace impact {

/// How a search for equilibrium ended.
struct EquilibriumSearch {
  bool found = false;
  int iterations = 0;
  double largest_force = 0.0;  ///< largest component of the net force on any point, M c²/R
};

/// The tangent stiffness of a field, the supported coordinates uncoupled, and with one point tied
/// to its place along an axis that shifts freely: since nothing acts along it from outside, the tie
/// carries no force, and only picks one of the equivalent shifts. Lower triangle. The places of the
/// entries are found once, and their order for the factorisation.
class TangentStiffness {
 public:
  using Matrix = Eigen::SparseMatrix<double>;
  using Factors = Eigen::SimplicialLDLT<Matrix>;

  void set(const ForceField& field, const PointArray& position);

  /// Of the matrix with `shift` added on its diagonal. nullptr: there are none.
  const Factors* factorise(double shift);

  double largest_diagonal() const { return matrix_.diagonal().maxCoeff(); }

 private:
  void find_places(const std::vector<Eigen::Triplet<double>>& entries);

  Matrix matrix_;
  std::vector<std::ptrdiff_t> places_;  ///< of each entry among the values; −1: none, above
  Factors factors_;
};

/// Finds equilibria of fields with the same bonds, supports and wall.
class EquilibriumSolver {
 public:
  /// Moves `position` to a minimum of the potential energy of the bonds, the wall and the load,
  /// with the rigid rotation held if the field holds it: the same state to which damped motion
  /// relaxes.
  ///
  /// Newton's method: each step solves K u = f for the displacements u, with K the tangent
  /// stiffness of bonds and wall (sparse LDLᵀ). Along an axis on which nothing acts from outside
  /// and no support holds, rigid shifts cost no energy and the mean displacement is held at zero;
  /// the rotation (RotationHold) is held by a Lagrange multiplier, supported coordinates by leaving
  /// them out. A backtracking line search on the energy keeps the search on its way down, and no
  /// point moves by more than a few ranges 1/a of the wall in one step. Where K is not positive in
  /// the directions that are free, a multiple of the unit matrix is added.
  ///
  /// Found when no component of the net force exceeds `tolerance` (M c²/R).
  EquilibriumSearch find(ForceField& field, PointArray& position, double tolerance);

  /// The displacements of one step of Newton's method from this position, which is close to an
  /// equilibrium: how far it still is from it.
  PointArray correction(ForceField field, PointArray position);

 private:
  TangentStiffness stiffness_;
};

}  // namespace impact
