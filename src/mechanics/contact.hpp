#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "lattice/lattice.hpp"

namespace impact {

/// A force on one point.
struct PointForce {
  std::int32_t point;    ///< its row or, in a report, its 0-based index within the body
  Eigen::Array2d force;  ///< M c²/R
};

/// The repulsion of eqs. (3) and (6) across a gap l, with the potential V₀ exp(−a l) and the force
/// a V₀ exp(−a l).
class Repulsion {
 public:
  /// `a` in 1/R, `v0` in M c².
  Repulsion(double a, double v0) : a_(a), v0_(v0) {}

  double a() const { return a_; }
  /// Of a contact, without what it has measured.
  Repulsion repulsion() const { return *this; }
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

 private:
  double a_;
  double v0_;
};

/// A repulsion between the first body and a wall or other bodies: what the last evaluation came
/// to, and what happened where points passed from one part of a surface to the next. Nothing here
/// is asked within the loops over points.
class Contact : public Repulsion {
 public:
  using Repulsion::Repulsion;
  explicit Contact(const Repulsion& law) : Repulsion(law) {}
  virtual ~Contact() = default;

  /// Force on the whole first body in the last evaluation, in M c²/R.
  const Eigen::Array2d& total_force() const { return total_force_; }
  /// Force on the whole body of this number (0: the first) in the last evaluation, in M c²/R.
  virtual Eigen::Array2d total_force_on(std::size_t body) const {
    return body == 0 ? total_force_ : -total_force_;
  }
  /// Largest force on one point in the last evaluation, in M c²/R.
  double largest_force() const { return largest_force_; }

  /// Takes over the forces of an evaluation made elsewhere.
  void take_in(const Eigen::Array2d& total_force, double largest_force) {
    total_force_ = total_force;
    largest_force_ = largest_force;
  }

  /// How many times as large as stiffness over point mass the square of a point's frequency against
  /// what it touches may be: 1 where that does not move, 2 where it is a point too.
  virtual double moving_ends() const { return 1.0; }
  /// Gap (R) from which on nothing is felt.
  virtual double threshold() const { return std::numeric_limits<double>::infinity(); }
  virtual double potential_energy(const ConstPoints& position) const = 0;

  /// The forces of more than `least_force` (M c²/R) on single points of the first body, by rows.
  virtual std::vector<PointForce> contacts(const ConstPoints& position,
                                           double least_force) const = 0;
  /// The reactions to those forces on points of what it meets.
  virtual std::vector<PointForce> reactions(const ConstPoints& /*position*/,
                                            double /*least_force*/) const {
    return {};
  }
  /// The same on points of the body of this number (0: the first).
  virtual std::vector<PointForce> forces_on(std::size_t body, const ConstPoints& position,
                                            double least_force) const {
    return body == 0 ? contacts(position, least_force) : reactions(position, least_force);
  }

  /// Compares what the points touch with the count before. To be called where a step of the motion
  /// is done, at the position of the last evaluation: those between, of the stages of an
  /// integrator, do not count.
  virtual void count_hops(const ConstPoints& /*position*/) {}
  /// Energy that appeared because a point in reach came to another bond, or in or out of reach,
  /// from count to count so far (M c²): the sum of the sizes of its changes.
  virtual double hops_size() const { return 0.0; }
  /// Energy of contacts that passed to another bond, times the size of the change of the normal,
  /// from count to count so far (M c²): forces that turned by a jump, even where no energy hops.
  virtual double turned() const { return 0.0; }

  /// What the points beside the surface would hold if it went on level from its ends (M c²).
  virtual double energy_beside(const ConstPoints& /*position*/) const { return 0.0; }

 protected:
  Contact(const Contact&) = default;
  Contact& operator=(const Contact&) = default;
  void clear() {
    total_force_.setZero();
    largest_force_ = 0.0;
  }
  void count(const Eigen::Array2d& force, double size) {
    total_force_ += force;
    if (size > largest_force_) largest_force_ = size;
  }

 private:
  Eigen::Array2d total_force_ = Eigen::Array2d::Zero();
  double largest_force_ = 0.0;
};

}  // namespace impact
