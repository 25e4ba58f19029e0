#include "solvers/make_bdf.hpp"

namespace impact {

bool has_bdf() { return false; }

std::unique_ptr<Integrator> make_bdf(double /*tolerance*/, const Scales& /*scales*/) {
  return nullptr;
}

}  // namespace impact
