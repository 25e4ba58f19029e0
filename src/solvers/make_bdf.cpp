#include "solvers/make_bdf.hpp"

#include "solvers/bdf.hpp"

namespace impact {

bool has_bdf() { return true; }

std::unique_ptr<Integrator> make_bdf(double tolerance, const Scales& scales) {
  return std::make_unique<Bdf>(tolerance, scales);
}

}  // namespace impact
