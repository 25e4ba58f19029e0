#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "mechanics/force_term.hpp"

namespace impact {

/// Dashpots on boundary points that take up what a wave brings (J. Lysmer and R. L. Kuhlemeyer,
/// J. Eng. Mech. Div. ASCE 95 (1969) 859): the force −ρ c_L v across the boundary and −ρ c_T v
/// along it, per length of boundary. A plane wave that meets the boundary head-on is not reflected.
/// There is no restoring force, so a push leaves a slow drift.
class ViscousBoundary : public ForceTerm {
 public:
  static constexpr const char* kName = "viscous boundary";
  static constexpr bool kIsDamping = true;

  struct Dashpot {
    std::int32_t point;          ///< row
    Eigen::Array2d coefficient;  ///< along x and y, M c/R
  };

  explicit ViscousBoundary(std::vector<Dashpot> dashpots) : dashpots_(std::move(dashpots)) {}

  /// The power that it takes away is absorbed.
  Losses add_damping_forces(const PointArray& velocity, PointArray& force) const {
    for (const Dashpot& dashpot : dashpots_) {
      force.row(dashpot.point) -= dashpot.coefficient.transpose() * velocity.row(dashpot.point);
    }
    return {0.0, power(velocity)};
  }
  void add_damping(int axis, MatrixEntries& entries) const {
    for (const Dashpot& dashpot : dashpots_) {
      entries.emplace_back(dashpot.point, dashpot.point, dashpot.coefficient(axis));
    }
  }

  /// The power that would be absorbed at these velocities (M c³/R).
  double power(const PointArray& velocity) const {
    double power = 0.0;
    for (const Dashpot& dashpot : dashpots_) {
      power += (dashpot.coefficient * velocity.row(dashpot.point).transpose().square()).sum();
    }
    return power;
  }

  const std::vector<Dashpot>& dashpots() const { return dashpots_; }

  /// Largest coefficient, M c/R.
  double largest_coefficient() const {
    double largest = 0.0;
    for (const Dashpot& dashpot : dashpots_) {
      largest = std::max(largest, dashpot.coefficient.maxCoeff());
    }
    return largest;
  }

 private:
  std::vector<Dashpot> dashpots_;
};

}  // namespace impact
