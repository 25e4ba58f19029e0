#include "run/make_integrator.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "mechanics/blanes_moan.hpp"
#include "mechanics/extrapolated_damping.hpp"
#include "mechanics/imex.hpp"
#include "mechanics/implicit_damping.hpp"
#include "mechanics/takahashi_imada.hpp"
#include "mechanics/velocity_verlet.hpp"
#include "reduced/modal_motion.hpp"
#include "reduced/reduced_motion.hpp"

namespace impact {
namespace {

/// The order that a method has, by its class; 0 where its step is not given. The compiler asks for
/// an integrator that is missing here.
int order_by_class(IntegratorKind integrator) {
  switch (integrator) {
    case IntegratorKind::kVerlet:
      return VelocityVerlet::kOrder;
    case IntegratorKind::kTakahashiImada:
      return TakahashiImada::kOrder;
    case IntegratorKind::kBlanesMoan:
      return BlanesMoan::kOrder;
    case IntegratorKind::kImplicitDamping:
      return ImplicitDamping::kOrder;
    case IntegratorKind::kExtrapolatedDamping:
      return ExtrapolatedDamping::kOrder;
    case IntegratorKind::kImex:
      return Imex::kOrder;
    case IntegratorKind::kReduced:
      return ReducedMotion::kOrder;
    case IntegratorKind::kModal:
      return ModalMotion::kOrder;
    case IntegratorKind::kAuto:
    case IntegratorKind::kBdf:
    case IntegratorKind::kRk8pd:
    case IntegratorKind::kNewton:
      break;
  }
  return 0;
}

TEST(Integrators, HaveTheOrderOfTheirClass) {
  for (const IntegratorTraits& method : kIntegrators) {
    EXPECT_EQ(method.order, order_by_class(method.kind)) << method.name;
    const bool is_given =
        method.stepping == Stepping::kFixed || method.stepping == Stepping::kReduced;
    EXPECT_EQ(method.order > 0, is_given) << method.name;
  }
}

/// Of those of fixed step, that the step of a damped lattice is not limited by its damping.
TEST(Integrators, AreStiffIfDampingDoesNotLimitTheirStep) {
  for (const IntegratorTraits& method : kIntegrators) {
    if (method.stepping != Stepping::kFixed || !method.holds_with_damping) continue;
    const double undamped = step_limit(method.kind, {1.0, 0.0});
    EXPECT_EQ(method.stiff, step_limit(method.kind, {1.0, 1e6}) >= 0.5 * undamped) << method.name;
  }
}

/// The lattice limits steps unless they solve for it, the contacts always.
TEST(Integrators, AreLimitedByWhatTheyDoNotSolveFor) {
  for (const IntegratorTraits& method : kIntegrators) {
    if (method.stepping != Stepping::kFixed) continue;
    const double of_lattice = step_limit(method.kind, {1e4, 0.0}, 1.0);
    EXPECT_EQ(of_lattice > 0.9 * step_limit(method.kind, {1e-4, 0.0}, 1.0), method.implicit_bonds)
        << method.name;
    EXPECT_LT(step_limit(method.kind, {1.0, 0.0}, 1e4), 0.2 * of_lattice + 1.0) << method.name;
  }
}

/// Those that are made, and no others, are of fixed step; lanes have those that say so.
TEST(Integrators, OfFixedStepAreMade) {
  for (const IntegratorTraits& method : kIntegrators) {
    if (method.stepping == Stepping::kFixed) {
      EXPECT_NE(make_fixed<ForceField>(method.kind), nullptr) << method.name;
      if (method.in_lanes) {
        EXPECT_NE(make_fixed<LaneField>(method.kind), nullptr) << method.name;
      } else {
        EXPECT_THROW(make_fixed<LaneField>(method.kind), std::logic_error) << method.name;
      }
    } else {
      EXPECT_THROW(make_fixed<ForceField>(method.kind), std::logic_error) << method.name;
    }
  }
}

}  // namespace
}  // namespace impact
