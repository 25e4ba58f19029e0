#pragma once

#include "mechanics/force_field.hpp"
#include "mechanics/state.hpp"

namespace impact {

/// What counts as of order one in a motion, for tolerances.
struct Scales {
  double length;    ///< of displacements, R
  double velocity;  ///< c
};

/// The motion as a system of the first order, ẏ = f(y), for solvers of such systems:
///   y = (x, v, dissipated energy, absorbed energy),
///   ẏ = (v, F(x, v)/m, power dissipated, power absorbed).
class FirstOrderForm {
 public:
  using Vector = Eigen::Map<Eigen::VectorXd>;
  using ConstVector = Eigen::Map<const Eigen::VectorXd>;

  explicit FirstOrderForm(Eigen::Index points);

  /// Length of y.
  Eigen::Index size() const { return 4 * points_ + 2; }

  /// y of this state, with no energy lost so far.
  void pack(const State& state, double* y) const;
  /// Overwrites position and velocity.
  void unpack(const double* y, State& state) const;
  Losses losses(const double* y) const { return {y[size() - 2], y[size() - 1]}; }

  /// Overwrites `rate` with ẏ. False when it is not finite.
  bool evaluate(ForceField& field, const double* y, double* rate);

  /// Absolute tolerances of y: `tolerance` in these scales, energies in that of N m (velocity)².
  void scale(const ForceField& field, double tolerance, const Scales& scales,
             double* tolerances) const;

 private:
  Eigen::Index points_;
  PointArray position_;
  PointArray velocity_;
  PointArray force_;
};

}  // namespace impact
