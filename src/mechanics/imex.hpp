#pragma once

#include <optional>

#include "mechanics/integrator.hpp"
#include "mechanics/mid_step_solver.hpp"

namespace impact {

/// Velocity Verlet for what changes slowly, the implicit mid-step rule for the linear forces of
/// damping and unstrained bonds (IMEX: A. Stern and E. Grinspun, Multiscale Model. Simul. 7 (2009)
/// 1779), so that vibrations which nothing excites set no limit to the step. With F the force
/// without damping, D the damping matrix and K an upper bound of the stiffness of the unstrained
/// bonds that both axes share (see MidStepSolver), turned as the lattice is in the middle of the
/// step:
///   (1 + h D/2m + h² K/4m) v½ = vₙ + h Fₙ/2m
///   xₙ₊₁ = xₙ + h v½
///   vₙ₊₁ = vₙ + h (Fₙ + Fₙ₊₁)/2m − h D v½/m
/// which is what half kicks by F + K (x − x₀) and an implicit mid-step of −K (x − x₀) − D v come
/// to. F being the whole force, K changes the error alone: it acts as masses added, h² K/4, so that
/// vibrations faster than 2/h come out slower, of six steps and more. One force evaluation and one
/// solution a step, which gives the damping too; the Cholesky factor is made anew when h changes.
///
/// Symmetric but for the angle, that of xₙ + h vₙ/2, which forwards and backwards differs by O(h³)
/// and so changes v½ by O(h⁵): of order 2, and errors have even powers of the step up to h⁴.
///
/// Stable if contacts, and bonds that are stiffer than K, add less than 4/h² to the squares of
/// frequencies; what bonds lose does no harm. Bonds that gain a small part g of their stiffness, as
/// strained ones do, may make vibrations faster than 2/(h √g) grow, by 1 + 2 √g a step at most.
class Imex : public FixedStepIntegrator<ForceField> {
 public:
  static constexpr int kOrder = 2;

  /// @throw std::invalid_argument see MidStepSolver.
  void restart(ForceField& field, const State& state) override;
  void take_velocity(ForceField& /*field*/, const State& /*state*/) override {}
  Losses step(ForceField& field, State& state, double h) override;
  double step_limit(double omega_squared, double gamma) const override;
  bool solves_for_bonds() const override { return true; }

 private:
  /// By which the lattice is turned against the unstrained one half a step later: the angle of the
  /// rotation that fits best.
  double middle_angle(const State& state, double h) const;

  std::optional<MidStepSolver> solver_;
  PointArray middle_velocity_;
  PointArray differences_;  ///< L v½, see MidStepSolver
};

}  // namespace impact
