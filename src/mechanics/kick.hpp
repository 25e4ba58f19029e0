#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/in_parts.hpp"
#include "kernels/kernels.hpp"
#include "kernels/lanes.hpp"
#include "lattice/lattice.hpp"

/// What integrators do with points, of one run or, with a number for each, of kLanes runs.
namespace impact {

/// v += factor · F.
inline void kick(double factor, const PointArray& force, PointArray& velocity) {
  in_parts(velocity.rows(), [&](Eigen::Index /*part*/, Eigen::Index first, Eigen::Index size) {
    kernels().kick(factor, force.data() + 2 * first, velocity.data() + 2 * first, 2 * size);
  });
}
inline void kick(const LaneNumbers& factor, const LaneArray& force, LaneArray& velocity) {
  kernels().lanes.kick(factor.data(), force.data(), velocity.data(), velocity.coordinates());
}

/// moved = x + factor · F.
inline void displace(double factor, const PointArray& force, const PointArray& position,
                     PointArray& moved) {
  in_parts(position.rows(), [&](Eigen::Index /*part*/, Eigen::Index first, Eigen::Index size) {
    kernels().displace(factor, force.data() + 2 * first, position.data() + 2 * first,
                       moved.data() + 2 * first, 2 * size);
  });
}
inline void displace(const LaneNumbers& factor, const LaneArray& force, const LaneArray& position,
                     LaneArray& moved) {
  kernels().lanes.displace(factor.data(), force.data(), position.data(), moved.data(),
                           position.coordinates());
}

/// v += factor · F, then x += h v.
inline void kick_and_drift(double factor, const PointArray& force, double h, PointArray& velocity,
                           PointArray& position) {
  in_parts(position.rows(), [&](Eigen::Index /*part*/, Eigen::Index first, Eigen::Index size) {
    kernels().kick_and_drift(factor, force.data() + 2 * first, h, velocity.data() + 2 * first,
                             position.data() + 2 * first, 2 * size);
  });
}
inline void kick_and_drift(const LaneNumbers& factor, const LaneArray& force, const LaneNumbers& h,
                           LaneArray& velocity, LaneArray& position) {
  kernels().lanes.kick_and_drift(factor.data(), force.data(), h.data(), velocity.data(),
                                 position.data(), position.coordinates());
}

/// Turns vectors counter-clockwise.
inline void turn(double angle, PointArray& vectors) {
  kernels().turn(std::cos(angle), std::sin(angle), vectors.col(0).data(), vectors.col(1).data(),
                 vectors.rows());
}

/// Σ a b.
inline double dot(const PointArray& a, const PointArray& b) {
  const auto column = [&](int axis) {
    double sum = 0.0;
    for (Eigen::Index first = 0; first < a.rows(); first += kPart) {
      sum += kernels().dot(&a(first, axis), &b(first, axis),
                           std::min<Eigen::Index>(kPart, a.rows() - first));
    }
    return sum;
  };
  return column(0) + column(1);
}
inline LaneNumbers dot(const LaneArray& a, const LaneArray& b) {
  LaneNumbers result;
  kernels().lanes.dot(a.data(), b.data(), a.points(), result.data());
  return result;
}

}  // namespace impact
