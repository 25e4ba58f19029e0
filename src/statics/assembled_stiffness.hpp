#pragma once

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
/// supports and kinds of terms: the places of the entries are found once. The supported coordinates
/// are uncoupled, and one point is tied to its place along an axis that shifts freely: where
/// nothing acts along it from outside, the tie carries no force, and only picks one of the
/// equivalent shifts.
template <class Scalar>
class AssembledStiffness {
 public:
  using Matrix = Eigen::SparseMatrix<Scalar>;

  bool empty() const { return places_.empty(); }
  /// All lanes get the same values at first, so that one that stays empty can be factorised.
  void assemble(const ForceField& field, const PointArray& position, int lane = 0);
  const Matrix& lower() const { return lower_; }
  double largest_diagonal(int lane = 0) const;

 private:
  using Entries = std::vector<Eigen::Triplet<double>>;

  void find_places(const Entries& entries, Eigen::Index coordinates);

  Matrix lower_;                        ///< triangle
  std::vector<std::ptrdiff_t> places_;  ///< of each entry among the values; −1: none, above
};

extern template class AssembledStiffness<double>;
extern template class AssembledStiffness<LaneScalar>;

}  // namespace impact
