#pragma once

#include "mechanics/force_term.hpp"

namespace impact {

/// Holds the rigid rotation of a body: keeps Σ R_i × (r_i − r_cm) = 0, with R_i the reference
/// positions about their centre (the rotational Eckart condition, C. Eckart, Phys. Rev. 47 (1935)
/// 552), so that the best-fitting rotation from the reference is exactly zero. The constraint is
/// linear in the positions; its forces λ ẑ × R_i have no resultant, do no work, and leave
/// accelerations that satisfy it. A pressed random disk would otherwise roll, since its centre of
/// mass lies off its middle.
class RotationHold : public ForceTerm {
 public:
  static constexpr const char* kName = "rotation hold";

  explicit RotationHold(const PointArray& reference) : direction_(reference.rows(), 2) {
    const PointArray arm = reference.rowwise() - reference.colwise().mean();
    direction_.col(0) = -arm.col(1);
    direction_.col(1) = arm.col(0);
    norm_squared_ = direction_.square().sum();
  }

  /// Adds the constraint's forces.
  void constrain(PointArray& force) { multiplier_ = take_out_rotation(force); }

  /// What turns the body, of forces or displacements: adds the returned multiple of direction().
  double take_out_rotation(PointArray& vectors) const {
    const double multiplier = -(direction_ * vectors).sum() / norm_squared_;
    vectors += multiplier * direction_;
    return multiplier;
  }

  /// ẑ × R_i: the constraint keeps its sum of products with the displacements at zero.
  const PointArray& direction() const { return direction_; }

  /// Torque of the constraint in the last constrain(), counter-clockwise, in M c².
  double torque() const { return multiplier_ * norm_squared_; }

 private:
  PointArray direction_;
  double norm_squared_;
  double multiplier_ = 0.0;
};

}  // namespace impact
