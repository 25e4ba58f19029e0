#include "mechanics/supports.hpp"

#include <algorithm>

namespace impact {

void Supports::constrain_stiffness(std::size_t points, MatrixEntries& entries) const {
  std::vector<bool> held_places(2 * points, false);
  for (const int axis : {0, 1}) {
    for (const std::int32_t point : held(axis)) {
      held_places[static_cast<std::size_t>(axis) * points + static_cast<std::size_t>(point)] = true;
    }
  }
  const auto is_held = [&](int place) { return held_places[static_cast<std::size_t>(place)]; };
  for (auto& entry : entries) {
    if (entry.row() == entry.col()) continue;
    if (is_held(entry.row()) || is_held(entry.col())) entry = {entry.row(), entry.col(), 0.0};
  }
}

void Supports::constrain_damping(int axis, MatrixEntries& entries) const {
  std::vector<std::int32_t> rows = held(axis);
  std::sort(rows.begin(), rows.end());
  const auto is_held = [&](const Eigen::Triplet<double>& entry) {
    return std::binary_search(rows.begin(), rows.end(), entry.row()) ||
           std::binary_search(rows.begin(), rows.end(), entry.col());
  };
  entries.erase(std::remove_if(entries.begin(), entries.end(), is_held), entries.end());
}

}  // namespace impact
