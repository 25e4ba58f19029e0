#include "solvers/make_rk8pd.hpp"

namespace impact {

bool has_rk8pd() { return false; }

std::unique_ptr<Integrator> make_rk8pd(double /*tolerance*/, const Scales& /*scales*/) {
  return nullptr;
}

}  // namespace impact
