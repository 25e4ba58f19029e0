#include "run/rk8pd_offer.hpp"

#include <utility>

namespace impact {
namespace {

MakeRk8pd& offered() {
  static MakeRk8pd make;
  return make;
}

}  // namespace

void offer_rk8pd(MakeRk8pd make) { offered() = std::move(make); }

bool offers_rk8pd() { return static_cast<bool>(offered()); }

std::unique_ptr<Integrator> offered_rk8pd(double tolerance, const Scales& scales) {
  return offers_rk8pd() ? offered()(tolerance, scales) : nullptr;
}

}  // namespace impact
