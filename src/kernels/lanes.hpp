#pragma once

#include <Eigen/Core>
#include <boost/align/aligned_allocator.hpp>
#include <cstddef>
#include <vector>

#include "kernels/kernels.hpp"
#include "lattice/lattice.hpp"

namespace impact {

/// A number of each of kLanes runs.
using LaneNumbers = Eigen::Array<double, kLanes, 1>;

/// Positions, velocities or forces of kLanes runs of one lattice side by side: of each point x of
/// all lanes, then y of all lanes.
class LaneArray {
 public:
  using Numbers = Eigen::Array<double, kLanes, Eigen::Dynamic>;

  /// All zero.
  void resize(Eigen::Index points) {
    numbers_.assign(static_cast<std::size_t>(Eigen::Index{2} * kLanes * points), 0.0);
  }

  Eigen::Index points() const { return coordinates() / 2; }
  Eigen::Index coordinates() const { return static_cast<Eigen::Index>(numbers_.size()) / kLanes; }
  const double* data() const { return numbers_.data(); }
  double* data() { return numbers_.data(); }

  /// A column a coordinate.
  Eigen::Map<Numbers, Eigen::AlignedMax> array() { return {data(), kLanes, coordinates()}; }
  Eigen::Map<const Numbers, Eigen::AlignedMax> array() const {
    return {data(), kLanes, coordinates()};
  }

  /// The points of one run.
  auto lane(int lane) {
    return Eigen::Map<PointArray, Eigen::Unaligned, LaneStride>(data() + lane, points(), 2);
  }
  auto lane(int lane) const {
    return Eigen::Map<const PointArray, Eigen::Unaligned, LaneStride>(data() + lane, points(), 2);
  }

 private:
  using LaneStride = Eigen::Stride<kLanes, 2 * kLanes>;
  using Aligned =
      std::vector<double, boost::alignment::aligned_allocator<double, kLanes * sizeof(double)>>;
  Aligned numbers_;
};

/// Where every point of kLanes runs is and how it moves.
struct LaneState {
  LaneArray position;  ///< R
  LaneArray velocity;  ///< c
};

}  // namespace impact
