#pragma once

#include <functional>
#include <memory>

#include "mechanics/first_order_form.hpp"
#include "mechanics/integrator.hpp"

namespace impact {

using MakeRk8pd = std::function<std::unique_ptr<Integrator>(double tolerance, const Scales&)>;

/// Makes the integrator rk8pd known to the scenes of a program. It is a reference for others and
/// brings GSL along, which the simulation node does not carry.
void offer_rk8pd(MakeRk8pd make);

bool offers_rk8pd();

/// nullptr when the program has not offered it.
std::unique_ptr<Integrator> offered_rk8pd(double tolerance, const Scales& scales);

}  // namespace impact
