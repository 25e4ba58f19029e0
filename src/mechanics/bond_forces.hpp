#pragma once

#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "lattice/lattice.hpp"

namespace impact {

/// Constants of every bond.
struct BondLaw {
  double k_a = 1.0;     ///< linear stiffness, M c²/R²
  double k_b = 1.0e-3;  ///< cubic stiffness, M c²/R⁴
  double eta = 0.0;     ///< viscosity, M c/R (η* M/N)
};

/// The springs of the lattice, eq. (1) with the dissipative sign of eqs. (3) and (6). Bond ij with
/// elongation x = |r_i − r_j| − l_ij and unit vector n from j to i exerts on i
///   f_i = −(k_a x + k_b x³) n − η (v_i − v_j),   f_j = −f_i.
/// The damping resists the whole relative velocity, not its part along the bond: linear momentum
/// is conserved, but angular momentum is not when η > 0 (a spinning disk slows down).
/// The loop over the bonds is instantiated for (k_b ≠ 0, η ≠ 0), so that a law without a cubic
/// term or without damping does not evaluate it.
class BondForces {
 public:
  BondForces(const Lattice& lattice, const BondLaw& law);

  /// Adds the force on each point (M c²/R). Returns the power that the damping dissipates,
  /// η Σ |v_i − v_j|² (M c³/R). Velocities are not read when the law has no damping.
  double add_forces(const PointArray& position, const PointArray& velocity,
                    PointArray& force) const {
    return (this->*kernel_)(position, velocity, force);
  }

  /// The same without damping.
  void add_elastic_forces(const PointArray& position, PointArray& force) const {
    (this->*elastic_kernel_)(position, position, force);
  }

  /// The entries of the Laplacian matrix of the damping, η on the diagonal for each bond of a point
  /// and −η between its ends (M c/R), those of one place to be added up.
  std::vector<Eigen::Triplet<double>> damping() const;

  Eigen::Index points() const { return static_cast<Eigen::Index>(begin_.size()) - 1; }

  /// Σ k_a x²/2 + k_b x⁴/4, in M c².
  double potential_energy(const PointArray& position) const {
    return potential_energy(position, 0, position.rows());
  }
  /// Of the bonds whose first point lies in the rows first … end − 1.
  double potential_energy(const PointArray& position, Eigen::Index first, Eigen::Index end) const;

  /// The entries of the tangent stiffness matrix −∂f/∂r (M c²/R²), those of one place to be added
  /// up; row and column i stand for x of point i, N + i for its y.
  std::vector<Eigen::Triplet<double>> stiffness(const PointArray& position) const;

  bool damped() const { return law_.eta != 0.0; }

  /// "bonds", with what the law has besides the linear spring: "bonds (cubic, damped)".
  std::string name() const;

 private:
  /// The second end of a bond and its natural length; the first end is the point whose list it
  /// stands in.
  struct Neighbour {
    std::int32_t point;
    double natural_length;
  };

  template <bool kCubic, bool kDamped>
  double add(const PointArray& position, const PointArray& velocity, PointArray& force) const;

  using Kernel = double (BondForces::*)(const PointArray&, const PointArray&, PointArray&) const;
  static Kernel choose_kernel(bool cubic, bool damped);

  BondLaw law_;
  std::vector<std::int32_t> begin_;  ///< bonds of point i: neighbours_[begin_[i]] … [begin_[i + 1]]
  std::vector<Neighbour> neighbours_;
  Kernel kernel_;
  Kernel elastic_kernel_;
};

}  // namespace impact
