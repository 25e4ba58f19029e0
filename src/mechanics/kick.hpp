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
inline void kick(const PointRows& rows, double factor, const PointArray& force,
                 PointArray& velocity) {
  for (const int axis : {0, 1}) {
    kernels().kick(factor, &force(rows.first, axis), &velocity(rows.first, axis), rows.size);
  }
}
inline void kick(double factor, const PointArray& force, PointArray& velocity) {
  in_parts(velocity.rows(), [&](Eigen::Index /*part*/, Eigen::Index first, Eigen::Index size) {
    kick({first, size}, factor, force, velocity);
  });
}
inline void kick(const LaneNumbers& factor, const LaneArray& force, LaneArray& velocity) {
  kernels().lanes.kick(factor.data(), force.data(), velocity.data(), velocity.coordinates());
}
/// Of all rows.
inline void kick(const PointRows& /*rows*/, const LaneNumbers& factor, const LaneArray& force,
                 LaneArray& velocity) {
  kick(factor, force, velocity);
}

/// moved = x + factor · F.
inline void displace(const PointRows& rows, double factor, const PointArray& force,
                     const PointArray& position, PointArray& moved) {
  for (const int axis : {0, 1}) {
    kernels().displace(factor, &force(rows.first, axis), &position(rows.first, axis),
                       &moved(rows.first, axis), rows.size);
  }
}
inline void displace(const PointRows& /*rows*/, const LaneNumbers& factor, const LaneArray& force,
                     const LaneArray& position, LaneArray& moved) {
  kernels().lanes.displace(factor.data(), force.data(), position.data(), moved.data(),
                           position.coordinates());
}

/// v += factor · F, then x += h v.
inline void kick_and_drift(const PointRows& rows, double factor, const PointArray& force, double h,
                           PointArray& velocity, PointArray& position) {
  for (const int axis : {0, 1}) {
    kernels().kick_and_drift(factor, &force(rows.first, axis), h, &velocity(rows.first, axis),
                             &position(rows.first, axis), rows.size);
  }
}
inline void kick_and_drift(double factor, const PointArray& force, double h, PointArray& velocity,
                           PointArray& position) {
  in_parts(position.rows(), [&](Eigen::Index /*part*/, Eigen::Index first, Eigen::Index size) {
    kick_and_drift({first, size}, factor, force, h, velocity, position);
  });
}
inline void kick_and_drift(const LaneNumbers& factor, const LaneArray& force, const LaneNumbers& h,
                           LaneArray& velocity, LaneArray& position) {
  kernels().lanes.kick_and_drift(factor.data(), force.data(), h.data(), velocity.data(),
                                 position.data(), position.coordinates());
}
inline void kick_and_drift(const PointRows& /*rows*/, const LaneNumbers& factor,
                           const LaneArray& force, const LaneNumbers& h, LaneArray& velocity,
                           LaneArray& position) {
  kick_and_drift(factor, force, h, velocity, position);
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
