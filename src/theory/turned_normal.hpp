#pragma once

namespace impact {

/// An impact without friction on a surface that lies turned by α: it rises with the slope tan α in
/// the direction in which the disk slides. The velocity v (sin γ, −cos γ) comes towards it with
/// v cos(γ − α) along its normal (−sin α, cos α); the impulse is 1 + e₀ times that, along the same
/// normal.

/// e along y of such an impact, from the restitution e₀ along the turned normal:
///   e = (1 + e₀) cos α cos(γ − α)/cos γ − 1 = (1 + e₀) (1 + tan α tan γ)/(1 + tan² α) − 1.
double restitution_on_slope(double restitution_along_normal, double slope, double tan_gamma);

/// The restitution e₀ along the turned normal, from e along y.
double restitution_along_normal(double restitution, double slope, double tan_gamma);

}  // namespace impact
