#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "mechanics/force_term.hpp"

namespace impact {

/// Holds single coordinates of points where they are, whatever pulls at them: a clamp holds both,
/// a grip that lets the sides contract or a sliding wall holds one.
class Supports : public ForceTerm {
 public:
  static constexpr const char* kName = "supports";
  static constexpr bool kInLanes = true;

  /// Rows of the points whose x, and of those whose y, is held.
  Supports(std::vector<std::int32_t> x, std::vector<std::int32_t> y)
      : held_{std::move(x), std::move(y)} {}

  /// Takes away the force on what is held.
  void constrain(Points force) const {
    for (const int axis : {0, 1}) {
      for (const std::int32_t point : held(axis)) force(point, axis) = 0.0;
    }
  }

  void constrain_stiffness(std::size_t points, MatrixEntries& entries) const;
  void constrain_damping(int axis, MatrixEntries& entries) const;
  bool shifts_freely(int axis) const { return held(axis).empty(); }

  /// Rows of the points whose coordinate is held; axis 0 is x, 1 is y.
  const std::vector<std::int32_t>& held(int axis) const {
    return held_[static_cast<std::size_t>(axis)];
  }

 private:
  std::array<std::vector<std::int32_t>, 2> held_;
};

}  // namespace impact
