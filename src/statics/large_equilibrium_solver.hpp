#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "statics/assembled_stiffness.hpp"
#include "statics/equilibrium_search.hpp"
#include "statics/multifrontal_factor.hpp"

namespace impact {

/// Takes the steps of a search for equilibrium among many points, from fewer factors than there are
/// steps. Little changes in K from one to the next but the contact with the wall, so that the
/// factors of an earlier K precondition conjugate gradients with the present one, which converge in
/// a few iterations; each then solves K u = f to 0.1 % of u in the norm of energy. With the
/// rotation held, they are kept on the displacements that leave it (N. I. M. Gould, M. E. Hribar
/// and J. Nocedal, SIAM J. Sci. Comput. 23, 2001, 1376). Where they do not converge soon, where K
/// is not positive and where a disk may roll, of which its energy says little, K is factorised.
class LargeEquilibriumSolver {
 public:
  static constexpr int kSearches = 1;
  using Searches = std::array<EquilibriumSearch*, kSearches>;

  /// Whether it is quicker than EquilibriumSolver, and than kLanes searches side by side.
  static bool is_for(Eigen::Index points) { return points > 5000; }

  /// One iteration. What a search finds does not depend on those before it, which must have had the
  /// same bonds, supports and kinds of terms.
  void advance(const Searches& searches);

 private:
  using Vector = Eigen::VectorXd;

  void step(EquilibriumSearch& search);
  bool may_iterate(const EquilibriumSearch& search) const;
  void factorise(const EquilibriumSearch& search);
  std::optional<Vector> by_conjugate_gradients(const EquilibriumSearch& search) const;
  Vector preconditioned(const EquilibriumSearch& search, const Vector& residual) const;

  AssembledStiffness<double, Eigen::NaturalOrdering<int>> stiffness_;
  std::optional<MultifrontalFactor> factor_;
  bool is_shifted_ = false;
  Vector response_;  ///< to the direction of the held rotation; empty: not held
};

}  // namespace impact
