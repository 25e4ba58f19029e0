#pragma once

#include <memory>

#include "mechanics/first_order_form.hpp"
#include "mechanics/integrator.hpp"

namespace impact {

/// The program has Rk8pd. It is a reference for the other integrators and brings GSL along, so that
/// a program without reference/make_rk8pd.cpp among its own sources links without_rk8pd.cpp.
bool has_rk8pd();

/// An Rk8pd; nullptr where there is none.
std::unique_ptr<Integrator> make_rk8pd(double tolerance, const Scales& scales);

}  // namespace impact
