#include "run/make_integrator.hpp"

#include <stdexcept>
#include <type_traits>

#include "lattice/input_error.hpp"
#include "mechanics/blanes_moan.hpp"
#include "mechanics/extrapolated_damping.hpp"
#include "mechanics/imex.hpp"
#include "mechanics/implicit_damping.hpp"
#include "mechanics/takahashi_imada.hpp"
#include "mechanics/velocity_verlet.hpp"
#include "scene/scene_parameters.hpp"
#include "solvers/make_bdf.hpp"
#include "solvers/make_rk8pd.hpp"

namespace impact {
namespace {

/// Typical displacement and speed of a scene, by which tolerances are measured.
Scales scales_of(const Scene& scene, double sound_speed) {
  if (scene.kind == SceneKind::kCollision) {
    const double v = scene.impact.normal_velocity();
    return {v / sound_speed, v};
  }
  return {scene.load.p / scene.material.k_a, scene.load.p / std::sqrt(scene.material.k_a)};
}

}  // namespace

template <class Field>
std::unique_ptr<FixedStepIntegrator<Field>> make_fixed(IntegratorKind integrator) {
  switch (integrator) {
    case IntegratorKind::kVerlet:
      return std::make_unique<BasicVelocityVerlet<Field>>();
    case IntegratorKind::kTakahashiImada:
      return std::make_unique<BasicTakahashiImada<Field>>();
    case IntegratorKind::kBlanesMoan:
      return std::make_unique<BasicBlanesMoan<Field>>();
    case IntegratorKind::kImplicitDamping:
      return std::make_unique<BasicImplicitDamping<Field>>();
    case IntegratorKind::kExtrapolatedDamping:
      return std::make_unique<BasicExtrapolatedDamping<Field>>();
    case IntegratorKind::kImex:
      if constexpr (std::is_same_v<Field, ForceField>) return std::make_unique<Imex>();
      break;
    case IntegratorKind::kAuto:
    case IntegratorKind::kBdf:
    case IntegratorKind::kRk8pd:
    case IntegratorKind::kReduced:
    case IntegratorKind::kModal:
    case IntegratorKind::kNewton:
      break;
  }
  throw std::logic_error(name_of(integrator) + " is no method of fixed step");
}

template std::unique_ptr<FixedStepIntegrator<ForceField>> make_fixed(IntegratorKind integrator);
template std::unique_ptr<FixedStepIntegrator<LaneField>> make_fixed(IntegratorKind integrator);

double step_limit(IntegratorKind integrator, const Spectrum& lattice, double contact_rate,
                  double inner_share) {
  const IntegratorKind scheme =
      integrator == IntegratorKind::kModal ? IntegratorKind::kImex : integrator;
  return make_fixed<ForceField>(scheme)->step_limit_with(lattice, contact_rate, inner_share);
}

void refuse_missing_integrator(const Scene& scene) {
  constexpr const char* kKey = "numerics.integrator";
  const IntegratorKind kind = scene.numerics.integrator;
  if (kind == IntegratorKind::kRk8pd && !has_rk8pd()) {
    throw bad_value(kKey, "rk8pd",
                    "another one here; the programs impact, sweep and work_precision have it");
  }
  if (kind == IntegratorKind::kBdf && !has_bdf()) {
    throw bad_value(kKey, "bdf",
                    "another one here; bdf needs a build with SUNDIALS (libsundials-dev)");
  }
}

std::unique_ptr<Integrator> make_integrator(const Scene& scene, const Resolution& resolution,
                                            double sound_speed) {
  const Scales scales = scales_of(scene, sound_speed);
  switch (resolution.integrator) {
    case IntegratorKind::kBdf:
      return make_bdf(resolution.tolerance, scales);
    case IntegratorKind::kRk8pd:
      return make_rk8pd(resolution.tolerance, scales);
    default:
      return make_fixed<ForceField>(resolution.integrator);
  }
}

}  // namespace impact
