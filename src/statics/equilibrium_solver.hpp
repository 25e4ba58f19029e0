#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <array>
#include <functional>
#include <type_traits>
#include <vector>

#include "kernels/lane_scalar.hpp"
#include "statics/assembled_stiffness.hpp"
#include "statics/equilibrium_search.hpp"

namespace impact {

/// Takes the steps of searches for equilibrium, of one with double and of up to kLanes side by side
/// with LaneScalar, by sparse LDLᵀ: the same steps to the last bit, whatever the other lanes do.
///
/// The order of elimination is found once, so all searches must have the same bonds, supports and
/// kinds of terms.
template <class Scalar>
class BasicEquilibriumSolver {
 public:
  static constexpr int kSearches = std::is_same_v<Scalar, LaneScalar> ? kLanes : 1;
  /// Each in the lane where it has been since its beginning. nullptr: an empty lane.
  using Searches = std::array<EquilibriumSearch*, kSearches>;

  /// One iteration in each search that has not finished.
  void advance(const Searches& searches);

 private:
  using Stiffness = AssembledStiffness<Scalar, Eigen::AMDOrdering<int>>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  struct Place {
    int lane;
    EquilibriumSearch* search;
  };

  void set_stiffness(const Place& place);
  void factorise(const std::vector<Place>& going);
  void solve(const std::vector<Place>& going);
  Vector solution() const;
  void take(const std::vector<Place>& going);
  Eigen::VectorXd of_lane(const Vector& numbers, int lane) const;
  void set_lane(int lane, const double* values);

  Stiffness stiffness_;
  Eigen::SimplicialLDLT<typename Stiffness::Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>>
      factors_;
  // In the order of elimination:
  Vector right_hand_side_;
  Vector solution_;
  Vector response_;  ///< to the direction of the held rotation; empty: not held
};

using EquilibriumSolver = BasicEquilibriumSolver<double>;
using LaneEquilibriumSolver = BasicEquilibriumSolver<LaneScalar>;

/// Takes a search to its end, among many points by LargeEquilibriumSolver. False when told to stop
/// before it, which is asked before every iteration; the search can be gone on with, to the same
/// bits but among many points.
bool solve(EquilibriumSearch& search, const std::function<bool()>& stop = {});

extern template class BasicEquilibriumSolver<double>;
extern template class BasicEquilibriumSolver<LaneScalar>;

}  // namespace impact
