#pragma once

#include <memory>

#include "reference/rk8pd.hpp"
#include "run/rk8pd_offer.hpp"

namespace impact {

/// Lets the scenes of this program have the integrator rk8pd.
inline void offer_reference_integrator() {
  offer_rk8pd([](double tolerance, const Scales& scales) {
    return std::make_unique<Rk8pd>(tolerance, scales);
  });
}

}  // namespace impact
