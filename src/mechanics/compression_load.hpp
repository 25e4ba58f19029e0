#pragma once

#include "mechanics/force_term.hpp"

namespace impact {

/// The compression of eq. (3): −(P/N) ŷ on each of the N points of the first body, the same
/// everywhere, like weight.
class CompressionLoad : public ForceTerm {
 public:
  static constexpr const char* kName = "compression load";

  /// `p` in M c²/R, on so many points.
  CompressionLoad(double p, Eigen::Index points) : p_(p), points_(points) {}

  void add_forces(const PointArray& /*position*/, PointArray& force) const {
    force.col(1).head(points_) -= p_ / static_cast<double>(points_);
  }

  double p() const { return p_; }  ///< M c²/R

  /// P times the height of the centre of mass, in M c².
  double potential_energy(const PointArray& position) const {
    return p_ * position.col(1).head(points_).mean();
  }
  void enter(const PointArray& position, EnergyLedger& ledger) const {
    ledger.load += potential_energy(position);
  }

 private:
  double p_;
  Eigen::Index points_;
};

}  // namespace impact
