#include <gtest/gtest.h>

#include "expect_input_error.hpp"
#include "run/compose.hpp"

namespace impact {
namespace {

TEST(WithoutSundials, BdfIsRefusedByTheNameOfItsPackage) {
  Scene scene;
  scene.kind = SceneKind::kContact;
  scene.material.eta = 10.0;
  scene.numerics.integrator = IntegratorKind::kBdf;
  EXPECT_INPUT_ERROR(refuse_impossible(scene),
                     "numerics.integrator: got bdf, allowed: another one here");
  EXPECT_INPUT_ERROR(refuse_impossible(scene), "libsundials-dev");
  scene.numerics.integrator = IntegratorKind::kImplicitDamping;
  EXPECT_NO_THROW(refuse_impossible(scene));
}

}  // namespace
}  // namespace impact
