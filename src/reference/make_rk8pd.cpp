#include "solvers/make_rk8pd.hpp"

#include "reference/rk8pd.hpp"

namespace impact {

bool has_rk8pd() { return true; }

std::unique_ptr<Integrator> make_rk8pd(double tolerance, const Scales& scales) {
  return std::make_unique<Rk8pd>(tolerance, scales);
}

}  // namespace impact
