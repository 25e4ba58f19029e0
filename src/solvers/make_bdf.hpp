#pragma once

#include <memory>

#include "mechanics/first_order_form.hpp"
#include "mechanics/integrator.hpp"

namespace impact {

/// The package was built with SUNDIALS, which Bdf needs.
bool has_bdf();

/// A Bdf; nullptr where there is none.
std::unique_ptr<Integrator> make_bdf(double tolerance, const Scales& scales);

}  // namespace impact
