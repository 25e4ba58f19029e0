#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <array>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

#include "kernels/lane_scalar.hpp"
#include "statics/equilibrium_search.hpp"

namespace impact {

/// Takes the steps of searches for equilibrium, of one with double and of up to kLanes side by side
/// with LaneScalar, by sparse LDLᵀ: the same steps to the last bit, whatever the other lanes do.
///
/// In K the supported coordinates are uncoupled, and one point is tied to its place along an axis
/// that shifts freely: since nothing acts along it from outside, the tie carries no force, and only
/// picks one of the equivalent shifts. The places of the entries and their order for the
/// factorisation are found once, so all searches must have the same bonds, supports and kinds of
/// terms.
template <class Scalar>
class BasicEquilibriumSolver {
 public:
  static constexpr int kSearches = std::is_same_v<Scalar, LaneScalar> ? kLanes : 1;
  /// Each in the lane where it has been since its beginning. nullptr: an empty lane.
  using Searches = std::array<EquilibriumSearch*, kSearches>;

  /// One iteration in each search that has not finished.
  void advance(const Searches& searches);

 private:
  using Matrix = Eigen::SparseMatrix<Scalar>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  using Entries = std::vector<Eigen::Triplet<double>>;
  struct Place {
    int lane;
    EquilibriumSearch* search;
  };

  void set_stiffness(const Place& place);
  void find_places(const Entries& entries, Eigen::Index coordinates);
  double largest_diagonal(int lane) const;
  void factorise(const std::vector<Place>& going);
  void solve(const std::vector<Place>& going);
  Vector solution() const;
  void take(const std::vector<Place>& going);

  Matrix stiffness_;                    ///< lower triangle
  std::vector<std::ptrdiff_t> places_;  ///< of each entry among the values; −1: none, above
  Eigen::SimplicialLDLT<Matrix> factors_;
  Vector right_hand_side_;
  Vector solution_;
  Vector response_;  ///< to the direction of the held rotation; empty: not held
};

using EquilibriumSolver = BasicEquilibriumSolver<double>;
using LaneEquilibriumSolver = BasicEquilibriumSolver<LaneScalar>;

/// Takes a search to its end. False when told to stop before it, which is asked before every
/// iteration; the search can be gone on with.
bool solve(EquilibriumSearch& search, const std::function<bool()>& stop = {});

extern template class BasicEquilibriumSolver<double>;
extern template class BasicEquilibriumSolver<LaneScalar>;

}  // namespace impact
