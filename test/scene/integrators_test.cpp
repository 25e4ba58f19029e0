#include "scene/integrators.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

/// How many integrators there are. The compiler asks for one that is missing here.
std::size_t number_up_to(IntegratorKind last) {
  switch (last) {
    case IntegratorKind::kAuto:
    case IntegratorKind::kVerlet:
    case IntegratorKind::kTakahashiImada:
    case IntegratorKind::kBlanesMoan:
    case IntegratorKind::kImplicitDamping:
    case IntegratorKind::kExtrapolatedDamping:
    case IntegratorKind::kImex:
    case IntegratorKind::kBdf:
    case IntegratorKind::kRk8pd:
    case IntegratorKind::kReduced:
    case IntegratorKind::kModal:
    case IntegratorKind::kNewton:
      return static_cast<std::size_t>(last) + 1;
  }
  return 0;
}

TEST(Integrators, HaveARowEach) {
  EXPECT_EQ(kIntegrators.size(), number_up_to(IntegratorKind::kNewton));
  std::set<std::string> names;
  for (std::size_t k = 0; k < kIntegrators.size(); ++k) {
    const auto kind = static_cast<IntegratorKind>(k);
    EXPECT_EQ(number_up_to(kind), k + 1);
    EXPECT_EQ(traits_of(kind).kind, kind);
    EXPECT_EQ(name_of(kind), traits_of(kind).name);
    names.insert(traits_of(kind).name);
  }
  EXPECT_EQ(names.size(), kIntegrators.size());
}

/// What lanes take is asked before `auto` has chosen: of what it may choose they take all but slow
/// impacts.
TEST(Integrators, ThatAutoMayChooseGoInLanes) {
  for (const IntegratorTraits& method : kIntegrators) {
    for (const bool damped : {false, true}) {
      for (const bool passing : {false, true}) {
        const bool may_fly = !passing;
        if (!is_automatic(method, {damped, passing, may_fly})) continue;
        EXPECT_TRUE(method.in_lanes || method.kind == IntegratorKind::kImex) << method.name;
        EXPECT_EQ(method.stepping, Stepping::kFixed) << method.name;
        EXPECT_TRUE(method.holds_with_damping || !damped) << method.name;
        EXPECT_TRUE(method.holds_with_passing || !passing) << method.name;
      }
    }
  }
}

TEST(Integrators, AreWhatTheirNamesSay) {
  EXPECT_TRUE(is_adaptive(IntegratorKind::kBdf));
  EXPECT_FALSE(is_adaptive(IntegratorKind::kVerlet));
  EXPECT_TRUE(solves_for_damping(IntegratorKind::kImplicitDamping));
  EXPECT_FALSE(solves_for_damping(IntegratorKind::kVerlet));
  EXPECT_FALSE(solves_for_damping(IntegratorKind::kBdf));
}

}  // namespace
}  // namespace impact
