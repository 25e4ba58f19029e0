#include "run/rk8pd_offer.hpp"

#include <utility>

#include "scene/parameter_table.hpp"

namespace impact {
namespace {

MakeRk8pd& offered() {
  static MakeRk8pd make;
  return make;
}

}  // namespace

void offer_rk8pd(MakeRk8pd make) { offered() = std::move(make); }

std::unique_ptr<Integrator> offered_rk8pd(double tolerance, const Scales& scales) {
  if (!offered()) {
    throw bad_value("numerics.integrator", "rk8pd",
                    "another one here; the programs impact, sweep and work_precision have it");
  }
  return offered()(tolerance, scales);
}

}  // namespace impact
