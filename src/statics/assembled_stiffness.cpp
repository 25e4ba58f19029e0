#include "statics/assembled_stiffness.hpp"

#include <algorithm>
#include <cstdint>

namespace impact {

template <class Scalar>
void AssembledStiffness<Scalar>::assemble(const ForceField& field, const PointArray& position,
                                          int lane) {
  const auto points = static_cast<std::int32_t>(position.rows());
  Entries entries = field.stiffness(position);
  for (const int axis : {0, 1}) {
    if (field.shifts_freely(axis)) entries.emplace_back(axis * points, axis * points, 1.0);
  }
  if (empty()) find_places(entries, Eigen::Index{2} * points);
  Scalar* const values = lower_.valuePtr();
  for (Eigen::Index k = 0; k < lower_.nonZeros(); ++k) in_lane(values[k], lane) = 0.0;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (places_[k] >= 0) in_lane(values[places_[k]], lane) += entries[k].value();
  }
}

template <class Scalar>
void AssembledStiffness<Scalar>::find_places(const Entries& entries, Eigen::Index coordinates) {
  std::vector<Eigen::Triplet<Scalar>> lower;
  for (const auto& entry : entries) {
    if (entry.row() < entry.col()) continue;
    lower.emplace_back(entry.row(), entry.col(), Scalar(entry.value()));
  }
  lower_.resize(coordinates, coordinates);
  lower_.setFromTriplets(lower.begin(), lower.end());
  places_.reserve(entries.size());
  for (const auto& entry : entries) {
    const int* const rows = lower_.innerIndexPtr();
    const int* const end = rows + lower_.outerIndexPtr()[entry.col() + 1];
    const int* const place =
        std::lower_bound(rows + lower_.outerIndexPtr()[entry.col()], end, entry.row());
    places_.push_back(entry.row() >= entry.col() ? place - rows : -1);
  }
}

template <class Scalar>
double AssembledStiffness<Scalar>::largest_diagonal(int lane) const {
  double largest = 0.0;
  for (Eigen::Index column = 0; column < lower_.cols(); ++column) {
    const int first = lower_.outerIndexPtr()[column];
    largest = std::max(largest, in_lane(lower_.valuePtr()[first], lane));
  }
  return largest;
}

template class AssembledStiffness<double>;
template class AssembledStiffness<LaneScalar>;

}  // namespace impact
