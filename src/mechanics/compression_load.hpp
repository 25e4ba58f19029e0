#pragma once

#include "lattice/lattice.hpp"

namespace impact {

/// The compression of eq. (3): −(P/N) ŷ on each of the N points, the same everywhere, like weight.
class CompressionLoad {
 public:
  /// `p` in M c²/R.
  explicit CompressionLoad(double p) : p_(p) {}

  void add_forces(PointArray& force) const {
    force.col(1) -= p_ / static_cast<double>(force.rows());
  }

  double p() const { return p_; }  ///< M c²/R

  /// P times the height of the centre of mass, in M c².
  double potential_energy(const PointArray& position) const { return p_ * position.col(1).mean(); }

 private:
  double p_;
};

}  // namespace impact
