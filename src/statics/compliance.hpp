#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "kernels/panel_cholesky.hpp"
#include "lattice/lattice.hpp"

namespace impact {

/// Displacements of some points under forces on the same points: row and column k of each matrix
/// belong to the k-th of them. In R over M c²/R.
struct PointCompliance {
  Eigen::MatrixXd xx;
  Eigen::MatrixXd xy;  ///< along x, under forces along y
  Eigen::MatrixXd yy;
};

/// What a free lattice of bonds with k_a = 1 does under forces that grow slowly: the rigid motion
/// apart, to first order, u = P K⁺ P f with the stiffness K and the projection P on what is neither
/// a shift nor a rotation. All masses being equal, u does not move the centre of mass, nor turn the
/// lattice about it.
///
/// One sparse Cholesky factor (see tied_stiffness()) and one solution a point that is asked for,
/// kept. Many threads may share one.
class Compliance {
 public:
  /// Of a lattice that cannot change its shape without a change of a bond.
  explicit Compliance(const Lattice& lattice);

  /// Of these points.
  PointCompliance among(const std::vector<std::int32_t>& points);

  /// Overwrites two sets of forces (M c²/R), a column each with the forces along x of all points
  /// and then those along y, by displacements (R).
  void respond(PointArray& loads);

  /// Takes out of two sets of forces or displacements, arranged in this way, what moves the lattice
  /// as a whole: P.
  void balance(PointArray& columns) const;

 private:
  void compute(std::int32_t point);
  void solve(PointArray& loads);

  std::mutex mutex_;
  Eigen::ArrayXd turn_;  ///< unit vector of a rotation about the centre of mass
  PanelCholesky factor_;
  std::vector<std::int32_t> place_;     ///< of a point among those computed; −1: not computed
  std::vector<std::int32_t> computed_;  ///< points
  /// Of each point that was computed, against itself and each one before it: xx, xy, yx, yy.
  std::vector<std::vector<std::array<double, 4>>> blocks_;
};

/// The compliance of a lattice, made when somebody asks for it, once.
class ComplianceOnDemand {
 public:
  std::shared_ptr<Compliance> of(const Lattice& lattice) {
    std::call_once(once_, [&] { compliance_ = std::make_shared<Compliance>(lattice); });
    return compliance_;
  }

 private:
  std::once_flag once_;
  std::shared_ptr<Compliance> compliance_;
};

}  // namespace impact
