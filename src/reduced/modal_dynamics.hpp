#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "kernels/padded_matrix.hpp"
#include "mechanics/bond_forces.hpp"
#include "mechanics/contact.hpp"
#include "reduced/bulk_modes.hpp"

namespace impact {

/// Generalised forces on the modes at equal intervals of time, zero before and after.
struct ForceCourse {
  double begin = 0.0;      ///< R/c
  double interval = 1.0;   ///< R/c
  Eigen::MatrixXd forces;  ///< a column each time

  /// Adds the force at a time, by cubic interpolation (Catmull–Rom).
  void add_to(Eigen::VectorXd& force, double time) const;
};

/// The bulk and the wall that it meets.
struct ModalSystem {
  std::shared_ptr<const BulkModes> modes;
  BondLaw law;
  Repulsion wall;
  std::shared_ptr<const ForceCourse> correction;  ///< none: nullptr
};

/// Of a body of mass 1 M.
struct ModalState {
  double height = 0.0;         ///< of the centre of mass, R
  double velocity = 0.0;       ///< upwards, c
  Eigen::VectorXd amplitudes;  ///< of the modes, M^(1/2) R; number 0: the angle times √I
  Eigen::VectorXd rates;       ///< M^(1/2) c; number 0: the spin times √I
};

/// A body above the potential wall at y = 0 that moves in its modes, in the frame that turns with
/// it: with the amplitudes q, the rows T that give the height of a point in contact, Λ the
/// stiffness and D the damping of the modes,
///   q̈ = −Λ q − D q̇ + Tᵀ f + g(t),  Ÿ = Σ f,  f = a V₀ exp(−a y),
///   y = Y + (sin φ, cos φ)·(s + u),
/// the force on the rotation being the torque at the lever arms s + u. Stepped as Imex steps all
/// points, but by its stiffness itself, of order 2, with one product with an inverse a step:
///   (μ + h D/2 + h² Λ/4) q̇½ = μ q̇ₙ + h Fₙ/2,  qₙ₊₁ = qₙ + h q̇½,
///   μ q̇ₙ₊₁ = μ q̇ₙ + h (Fₙ + Fₙ₊₁)/2 − h D q̇½,
/// F the forces without damping. The wall, stiff as κ = a f on a point, needs h² κ below 4 times
/// the mass that it meets. With μ = 1 that is at most a point's, since what is solved for lends no
/// inertia. So modes get some, μ = 1 + h² Λ/12: contacts which are softer than the lattice below
/// them then hold in steps of any length, and errors stay h².
class ModalDynamics {
 public:
  static constexpr double kAddedInertia = 1.0 / 12.0;  ///< of a mode, over h² Λ

  ModalDynamics(ModalSystem system, ModalState start, double step);

  void set_step(double step);
  /// Bound of the square of the frequency (c/R) that the wall, stiff as now, gives to the points in
  /// contact, stable below 4/h²: the greatest sum of a row of |H μ⁻¹ Hᵀ| a f, H the rows that give
  /// their heights.
  double contact_rate() const;
  /// From now on.
  void set_correction(std::shared_ptr<const ForceCourse> correction) {
    system_.correction = std::move(correction);
  }
  /// Returns the energy that the damping took, M c².
  double step();

  const ModalState& state() const { return state_; }
  const ModalSystem& system() const { return system_; }
  double time() const { return time_; }  ///< since the start, R/c
  /// M c², without what a motion along x has.
  double kinetic_energy() const;
  double angle() const { return state_.amplitudes(0) / root_inertia_; }  ///< rad
  double spin() const { return state_.rates(0) / root_inertia_; }        ///< c/R
  double angular_acceleration() const { return force_(0) / root_inertia_; }
  double force() const { return contact_.sum(); }               ///< of the wall, M c²/R
  double largest_force() const { return contact_.maxCoeff(); }  ///< on a point
  /// In the middle of the latest step: those at its ends may swing about it where damping is stiff.
  const Eigen::VectorXd& middle_rates() const { return middle_; }
  const Eigen::VectorXd& contact_forces() const { return contact_; }

 private:
  void update_forces();

  ModalSystem system_;
  ModalState state_;
  double time_ = 0.0;
  double step_ = 0.0;
  double root_inertia_;
  Eigen::VectorXd stiffness_;
  Eigen::ArrayXd inertia_;   ///< μ
  PointArray arm_;           ///< of the points in contact
  Eigen::MatrixXd heights_;  ///< of these points, by the modes
  /// Displacements of these points, along x and then along y, by the modes but the rotation.
  PaddedMatrix displacements_;
  PaddedMatrix transposed_;
  PaddedMatrix inverse_;
  PaddedMatrix response_;  ///< |H μ⁻¹ Hᵀ|
  Eigen::VectorXd displaced_;
  Eigen::ArrayXd x_;
  Eigen::ArrayXd y_;
  Eigen::VectorXd contact_;
  Eigen::VectorXd pushes_;  ///< the same in the frame of the body, along x and then along y
  Eigen::VectorXd product_;
  mutable Eigen::VectorXd rates_;
  Eigen::VectorXd force_;  ///< on the modes, without damping
  Eigen::VectorXd kicked_;
  Eigen::VectorXd middle_;
  Eigen::VectorXd damped_;
};

}  // namespace impact
