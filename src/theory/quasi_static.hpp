#pragma once

namespace impact {

/// The quasi-static theory of impact, eq. (4), for a disk of mass 1 M and radius 1 R:
///   ξ″ = −πE* (ξ + τ₀ ξ′)/ln(4R/ξ),   ξ(0) = 0,  ξ′(0) = v.
struct QuasiStaticImpact {
  double effective_modulus = 0.0;  ///< E*, M c²/R²: E/(1 − ν²) in the paper, E in plane stress
  double dissipation_time = 0.0;   ///< τ₀, R/c
  double velocity = 0.0;           ///< v, c
};

/// The speed of longitudinal waves √(E/ρ) (c) of a disk of density ρ = M/(πR²).
double sound_speed(double young_modulus);

/// τ = π (R/c_s) √ln(4 c_s/v), in R/c; speeds in c.
double contact_time(double sound_speed, double velocity);

/// The closed form of eq. (5): e = d₁ √(1 − d₂/√ln(4 c_s/v)); NaN where the root is not real.
double closed_form_restitution(double d1, double d2, double velocity_by_sound_speed);

/// The paper's d₂ = 2π τ₀ E*/(ρ R c_s).
double paper_d2(const QuasiStaticImpact& impact, double sound_speed);

}  // namespace impact
