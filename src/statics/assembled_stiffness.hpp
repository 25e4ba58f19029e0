#pragma once

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

#include "kernels/lane_scalar.hpp"
#include "mechanics/force_field.hpp"

namespace impact {

inline double in_lane(const double& number, int /*lane*/) { return number; }
inline double& in_lane(double& number, int /*lane*/) { return number; }
inline double in_lane(const LaneScalar& number, int lane) { return number[lane]; }
inline double& in_lane(LaneScalar& number, int lane) { return number[lane]; }

/// The tangent stiffness K of a field, again and again, or of kLanes fields with the same bonds,
/// supports and kinds of terms: the places of the entries are found once, in an order of
/// elimination of Eigen's. The supported coordinates are uncoupled, and one point is tied to its
/// place along an axis that shifts freely: where nothing acts along it from outside, the tie
/// carries no force, and only picks one of the equivalent shifts.
template <class Scalar, class Ordering>
class AssembledStiffness {
 public:
  using Matrix = Eigen::SparseMatrix<Scalar>;

  bool empty() const { return values_.empty(); }
  /// All lanes get the same values at first, so that one that stays empty can be factorised.
  void assemble(const ForceField& field, const PointArray& position, int lane = 0);
  /// Of the matrix in the order of elimination the upper triangle, which is all that is stored.
  const Matrix& upper() const { return upper_; }
  /// Row of a coordinate, x of all points and then y of all.
  Eigen::Index place(Eigen::Index coordinate) const {
    return order_.size() == 0 ? coordinate : order_.indices()[coordinate];
  }
  double largest_diagonal(int lane = 0) const;

 private:
  void find_places(Eigen::Index coordinates);

  Matrix upper_;
  Eigen::PermutationMatrix<Eigen::Dynamic> order_;  ///< empty: the natural one
  MatrixEntries entries_;                           ///< kept for their memory
  std::vector<std::ptrdiff_t> values_;  ///< where each entry is added up; −1: nowhere, below
};

}  // namespace impact
