#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

namespace impact {

/// A force on one point of a body.
struct PointForce {
  std::int32_t point;    ///< 0-based index within the body
  Eigen::Array2d force;  ///< M c²/R
};

/// What both kinds of wall have in common: the repulsion of eqs. (3) and (6) across a gap l, with
/// the potential V₀ exp(−a l) and the force a V₀ exp(−a l), and what the last evaluation came to.
class WallContact {
 public:
  /// `a` in 1/R, `v0` in M c².
  WallContact(double a, double v0) : a_(a), v0_(v0) {}

  double a() const { return a_; }
  /// Force across this gap (R), in M c²/R.
  double force_at(double gap) const { return a_ * v0_ * std::exp(-a_ * gap); }
  /// Potential energy across this gap (R), in M c².
  double potential_at(double gap) const { return v0_ * std::exp(-a_ * gap); }
  /// The gap (R) across which this force (M c²/R) acts.
  double gap_of_force(double force) const { return std::log(a_ * v0_ / force) / a_; }
  /// The gap (R) across which this energy (M c²) is stored.
  double gap_of_energy(double energy) const { return std::log(v0_ / energy) / a_; }
  /// The stiffness where this force acts: −dF/dl = a F, in M c²/R².
  double stiffness(double force) const { return a_ * force; }

  /// Force of the wall on the whole disk in the last evaluation, in M c²/R.
  const Eigen::Array2d& total_force() const { return total_force_; }
  /// Largest force on one point in the last evaluation, in M c²/R.
  double largest_force() const { return largest_force_; }

  /// Takes over the forces of an evaluation made elsewhere.
  void take_in(const Eigen::Array2d& total_force, double largest_force) {
    total_force_ = total_force;
    largest_force_ = largest_force;
  }

 protected:
  void clear() {
    total_force_.setZero();
    largest_force_ = 0.0;
  }
  void count(const Eigen::Array2d& force, double size) {
    total_force_ += force;
    if (size > largest_force_) largest_force_ = size;
  }

 private:
  double a_;
  double v0_;
  Eigen::Array2d total_force_ = Eigen::Array2d::Zero();
  double largest_force_ = 0.0;
};

}  // namespace impact
