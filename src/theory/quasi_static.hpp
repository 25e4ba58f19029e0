#pragma once

namespace impact {

/// The quasi-static theory of impact, eq. (4), for a disk of mass 1 M and radius 1 R:
///   ξ″ = −πE* (ξ + τ₀ ξ′)/ln(4R/ξ),   ξ(0) = 0,  ξ′(0) = v.
struct QuasiStaticImpact {
  double effective_modulus = 0.0;  ///< E*, M c²/R²: E/(1 − ν²) in the paper, E in plane stress
  double dissipation_time = 0.0;   ///< τ₀, R/c
  double velocity = 0.0;           ///< v, c
};

/// Where the integration of eq. (4) ends.
enum class EndOfImpact {
  kContactTime,   ///< at τ of contact_time(), as in the paper
  kNoCompression  ///< when ξ comes back to 0
};

/// The speed of longitudinal waves √(E/ρ) (c) of a disk of density ρ = M/(πR²).
double sound_speed(double young_modulus);

/// τ = π (R/c_s) √ln(4 c_s/v), in R/c; speeds in c.
double contact_time(double sound_speed, double velocity);

/// e = −ξ′(end)/v from eq. (4), integrated by GSL's rk8pd to a relative error below 10⁻⁹.
/// `sound_speed` enters only where the end is the contact time.
double quasi_static_restitution(const QuasiStaticImpact& impact, EndOfImpact end,
                                double sound_speed);

/// The dissipation time τ₀ (R/c) at which eq. (4), with ξ back at 0 as its end, loses the part
/// `loss` = 1 − e² of the energy; found by Brent's method to a relative error below 10⁻⁹. NaN where
/// there is none: outside 0 ≤ loss < 1, and for v ≥ c_s, which is not quasi-static.
double dissipation_time(double effective_modulus, double velocity, double loss);

/// The closed form of eq. (5): e = d₁ √(1 − d₂/√ln(4 c_s/v)); NaN where the root is not real.
double closed_form_restitution(double d1, double d2, double velocity_by_sound_speed);

/// The paper's d₂ = 2π τ₀ E*/(ρ R c_s).
double paper_d2(const QuasiStaticImpact& impact, double sound_speed);

}  // namespace impact
