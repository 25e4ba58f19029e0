#pragma once

#include <algorithm>
#include <cmath>
#include <complex>

#include "mechanics/force_field.hpp"
#include "mechanics/state.hpp"
#include "test_lattices.hpp"

namespace impact {

/// Two points of mass 1/2 at distance 1 on the x axis, joined by a spring k_a = 1, stretched and
/// let go: the elongation x follows ẍ = −ω² x − γ ẋ.
struct Oscillator {
  static constexpr double kStretch = 0.01;
  static constexpr double kOmegaSquared = 4.0;  // 2 k_a/m

  explicit Oscillator(double damping_rate)
      : gamma(damping_rate),
        field{BondForces(two_points(), {1.0, 0.0, damping_rate / 4.0}), 0.5},
        state{0.0, 0, two_points().points, PointArray::Zero(2, 2)} {
    state.position(1, 0) += kStretch;
  }

  double elongation() const { return state.position(1, 0) - state.position(0, 0) - 1.0; }
  double energy() const {
    return 0.25 * state.velocity.square().sum() + field.bonds.potential_energy(state.position);
  }

  /// Elongation at a time after a stretch and release at t = 0.
  double exact(double time) const {
    // x = (r₂ exp(−r₁ t) − r₁ exp(−r₂ t))/(r₂ − r₁), r₁ r₂ = ω²: no difference of like numbers.
    const std::complex<double> fast =
        (gamma + std::sqrt(std::complex<double>(gamma * gamma - 4.0 * kOmegaSquared))) / 2.0;
    const std::complex<double> slow = kOmegaSquared / fast;
    const std::complex<double> shape =
        (fast * std::exp(-slow * time) - slow * std::exp(-fast * time)) / (fast - slow);
    return kStretch * shape.real();
  }

  double gamma;
  ForceField field;
  State state;
};

/// How far an integrator was off in any of its states.
struct Oscillation {
  double error = 0.0;   ///< of the elongation, in units of the stretch
  double defect = 0.0;  ///< of the energy balance, in units of the energy at the start
  std::uint64_t evaluations = 0;
};

/// The oscillator up to `time` in equal steps.
template <class Integrator>
Oscillation oscillate(Integrator&& integrator, double gamma, double time, int steps) {
  Oscillator oscillator(gamma);
  const double start = oscillator.energy();
  integrator.restart(oscillator.field, oscillator.state);
  Oscillation found;
  double dissipated = 0.0;
  for (int k = 1; k <= steps; ++k) {
    dissipated += integrator.step(oscillator.field, oscillator.state, time / steps).dissipated;
    const double error = oscillator.elongation() - oscillator.exact(k * time / steps);
    const double defect = oscillator.energy() + dissipated - start;
    found.error = std::max(found.error, std::abs(error) / Oscillator::kStretch);
    found.defect = std::max(found.defect, std::abs(defect) / start);
  }
  found.evaluations = oscillator.field.evaluations;
  return found;
}

/// The exponent p of a fit of error ∝ toleranceᵖ over tolerances 10⁻⁴ … 10⁻¹¹.
template <class MakeIntegrator>
double exponent_of_tolerance(const MakeIntegrator& make, double gamma, double time) {
  double sum = 0.0;
  double weights = 0.0;
  for (int k = 4; k <= 11; ++k) {
    const double tolerance = std::pow(10.0, -k);
    const double from_middle = 7.5 - k;
    sum += from_middle * std::log10(oscillate(make(tolerance), gamma, time, 10).error);
    weights += from_middle * from_middle;
  }
  return sum / weights;
}

}  // namespace impact
