#pragma once

#include <Eigen/Core>

#include "mechanics/system.hpp"

namespace impact {

/// The way from the initial state to a minimum of the potential energy of the bonds, the wall and
/// the load, with the rigid rotation held if the field holds it: the same state at rest to which
/// damped motion relaxes. An EquilibriumSolver takes the steps. The energy that damped motion would
/// lose on the way is not known.
///
/// Newton's method: each step solves K u = f for the displacements u, with K the tangent
/// stiffness of bonds and wall. Along an axis on which nothing acts from outside and no support
/// holds, rigid shifts cost no energy and the mean displacement is held at zero; the rotation
/// (RotationHold) is held by a Lagrange multiplier, supported coordinates by leaving them out. A
/// backtracking line search on the energy keeps the search on its way down. Before a wall no point
/// moves further in one step than a few ranges 1/a, or half as far again as it did in a step on
/// which the energy fell nearly as its slope said. Where K is not positive in the directions that
/// are free, a multiple of the unit matrix is added, a hundredth of it at the next step.
class EquilibriumSearch : public System {
 public:
  using Vector = Eigen::VectorXd;

  /// Ends when no component of the net force exceeds `tolerance` (M c²/R), or cannot go on.
  EquilibriumSearch(ForceField field, State initial, double tolerance);

  bool finished() const { return finished_; }
  bool found() const { return largest_force_ <= tolerance_; }
  /// At the end, the displacements of one more step: how far it still is to the equilibrium.
  const PointArray& correction() const { return correction_; }

  // What the solver asks for and gives, until the search has finished.

  /// The net force f on the points: x of all and, after them, y of all.
  Eigen::Map<const Vector> force() const { return {force_.data(), force_.size()}; }
  /// To be added on the diagonal of K, in units of its largest element.
  double shift() const;
  /// Whether K is wanted at another place than before.
  bool needs_stiffness() const { return needs_stiffness_; }
  /// Goes on by the solution u of K u = f and, if the rotation is held, that for the right-hand
  /// side RotationHold::direction(); not finite: there is none. `scale`: the largest element on the
  /// diagonal of K.
  void take(const Vector& solution, const Vector& response, double scale);
  /// Whether all that is missing is a correction for which the factors of the step just taken do:
  /// another take() may follow.
  bool needs_correction() const { return ends_ && !finished_ && keeps_factors_; }

 private:
  double evaluate();
  PointArray shaped(const Vector& step) const;
  void go(const PointArray& step);
  bool line_search(const PointArray& step);
  void limit_moves(double length, double gain, double move);

  double tolerance_;
  PointArray force_;
  PointArray correction_;
  double largest_force_;
  double least_limit_;  ///< of the move of a point in a step, R; infinite without a wall
  double limit_;        ///< the present one
  int attempt_ = 0;     ///< at a step, each with a greater shift
  bool needs_stiffness_ = true;
  bool keeps_factors_ = false;  ///< those of the latest step, which had no shift
  bool ends_;
  bool finished_ = false;
};

/// EquilibriumSearch::correction() of a state that came close to an equilibrium in another way.
PointArray equilibrium_correction(const ForceField& field, const State& state);

}  // namespace impact
