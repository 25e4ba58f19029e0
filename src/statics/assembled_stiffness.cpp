#include "statics/assembled_stiffness.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace impact {

template <class Scalar, class Ordering>
void AssembledStiffness<Scalar, Ordering>::assemble(const ForceField& field,
                                                    const PointArray& position, int lane) {
  const auto points = static_cast<std::int32_t>(position.rows());
  field.find_stiffness(position, entries_);
  for (const int axis : {0, 1}) {
    if (field.shifts_freely(axis)) entries_.emplace_back(axis * points, axis * points, 1.0);
  }
  if (empty()) find_places(Eigen::Index{2} * points);
  Scalar* const values = upper_.valuePtr();
  for (Eigen::Index k = 0; k < upper_.nonZeros(); ++k) in_lane(values[k], lane) = 0.0;
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    if (values_[k] >= 0) in_lane(values[values_[k]], lane) += entries_[k].value();
  }
}

template <class Scalar, class Ordering>
void AssembledStiffness<Scalar, Ordering>::find_places(Eigen::Index coordinates) {
  MatrixEntries above;
  std::copy_if(entries_.begin(), entries_.end(), std::back_inserter(above),
               [](const auto& entry) { return entry.row() <= entry.col(); });
  Eigen::SparseMatrix<double> matrix(coordinates, coordinates);
  matrix.setFromTriplets(above.begin(), above.end());
  Ordering()(matrix.selfadjointView<Eigen::Upper>(), order_);
  if (order_.size() != 0) {
    order_ = order_.inverse().eval();
    matrix = matrix.selfadjointView<Eigen::Upper>().twistedBy(order_);
  }
  upper_ = Eigen::SparseMatrix<double>(matrix.triangularView<Eigen::Upper>()).cast<Scalar>();
  values_.reserve(entries_.size());
  for (const auto& entry : entries_) {
    const auto row = static_cast<int>(place(entry.row()));
    const Eigen::Index column = place(entry.col());
    const int* const rows = upper_.innerIndexPtr();
    const int* const value = std::lower_bound(rows + upper_.outerIndexPtr()[column],
                                              rows + upper_.outerIndexPtr()[column + 1], row);
    values_.push_back(row <= column ? value - rows : -1);
  }
}

template <class Scalar, class Ordering>
double AssembledStiffness<Scalar, Ordering>::largest_diagonal(int lane) const {
  double largest = 0.0;
  for (Eigen::Index column = 0; column < upper_.cols(); ++column) {
    const int last = upper_.outerIndexPtr()[column + 1] - 1;
    largest = std::max(largest, in_lane(upper_.valuePtr()[last], lane));
  }
  return largest;
}

template class AssembledStiffness<double, Eigen::NaturalOrdering<int>>;
template class AssembledStiffness<double, Eigen::AMDOrdering<int>>;
template class AssembledStiffness<LaneScalar, Eigen::AMDOrdering<int>>;

}  // namespace impact
