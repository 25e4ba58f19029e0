#pragma once

#include "theory/quasi_static.hpp"

namespace impact {

/// Where the integration of eq. (4) ends.
enum class EndOfImpact {
  kContactTime,   ///< at τ of contact_time(), as in the paper
  kNoCompression  ///< when ξ comes back to 0
};

/// e = −ξ′(end)/v from eq. (4), integrated by GSL's rk8pd to a relative error below 10⁻⁹.
/// `sound_speed` enters only where the end is the contact time.
double quasi_static_restitution(const QuasiStaticImpact& impact, EndOfImpact end,
                                double sound_speed);

/// The dissipation time τ₀ (R/c) at which eq. (4), with ξ back at 0 as its end, loses the part
/// `loss` = 1 − e² of the energy; found by Brent's method to a relative error below 10⁻⁹. NaN where
/// there is none: outside 0 ≤ loss < 1, and for v ≥ c_s, which is not quasi-static.
double dissipation_time(double effective_modulus, double velocity, double loss);

}  // namespace impact
