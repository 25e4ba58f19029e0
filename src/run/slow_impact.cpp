#include "run/slow_impact.hpp"

#include <algorithm>
#include <cmath>

#include "run/expected_time.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

constexpr double kFastestWall = 2.0;    // a v over √(k_a/M)
constexpr double kFastestDisk = 0.006;  // v over √(k_a R²/M)
constexpr double kFastestModal = 0.03;  // v over √(k_a R²/M)
constexpr Eigen::Index kFewestModal = 100;
constexpr double kMostInContact = 100.0;
constexpr double kLongestWayOfReduced = 0.3;  // a v h of the last run
constexpr double kCoarseningOfReduced = 1.25;

/// The fraction of the impact's energy below which what a point holds counts as out of reach.
double out_of_reach(const Scene& scene) { return 1e-4 * scene.numerics.error; }

/// What `modal` is likely to leave out of e, relative: fitted to 258 random scenes (100 … 3000
/// points, v = 0.001 … 0.03 √(k_a R²/M), a = 60 … 1500/R, η = 0.05 … 300 √(k_a M)), two of three of
/// which are within a factor of 4.5.
double likely_left_out(const Scene& scene, double points) {
  const double root_stiffness = std::sqrt(scene.material.k_a);
  const double of_speed = std::pow(scene.impact.normal_velocity() / root_stiffness / 0.01, 2.25);
  const double of_damping = 1.0 + scene.material.eta / root_stiffness / 3.0;
  const double of_rim = scene.disk.recipe.rim ? 1.0 : 5.0;
  const double of_placement = scene.disk.recipe.placement == Placement::kUniform ? 2.0 : 1.0;
  return 3e-6 * of_speed * of_damping * of_rim * of_placement *
         std::pow(scene.wall.a / 300.0, 1.5) * std::sqrt(1099.0 / points);
}

/// The points within reach of the wall when the disk just touches it: on the rim those of a chord,
/// and those of the segment that it cuts off.
double points_in_contact(const Scene& scene, double points) {
  const double v = scene.impact.normal_velocity();
  const double reach = std::min(1.0, std::log(1.0 / out_of_reach(scene)) / scene.wall.a + v);
  const double half_chord = std::sqrt(2.0 * reach);
  return half_chord * std::sqrt(points / M_PI) * 2.0 +
         points * half_chord * reach * 4.0 / 3.0 / M_PI;
}

}  // namespace

bool may_be_reduced(const Scene& scene, Eigen::Index points) {
  const double speed = scene.impact.normal_velocity() / std::sqrt(scene.material.k_a);
  return scene.numerics.integrator == IntegratorKind::kAuto && can_be_reduced(scene) &&
         !scene.numerics.are_given() && scene.wall.a * speed <= kFastestWall &&
         speed <= kFastestDisk &&
         points_in_contact(scene, static_cast<double>(points)) <= kMostInContact;
}

bool may_be_modal(const Scene& scene, Eigen::Index points) {
  const double speed = scene.impact.normal_velocity() / std::sqrt(scene.material.k_a);
  return scene.numerics.integrator == IntegratorKind::kAuto && can_be_modal(scene) &&
         scene.is_damped() && scene.flies_without_forces() && !scene.numerics.are_given() &&
         speed <= kFastestModal && points >= kFewestModal &&
         likely_left_out(scene, static_cast<double>(points)) <=
             kMostLeftOut * scene.numerics.error &&
         points_in_contact(scene, static_cast<double>(points)) <= kMostInContact;
}

Resolution reduced_resolution(const Scene& scene) {
  const double way = scene.wall.a * scene.impact.normal_velocity();
  Resolution resolution;
  resolution.integrator = IntegratorKind::kReduced;
  resolution.step = kLongestWayOfReduced / way;
  resolution.coarsening = kCoarseningOfReduced;
  return resolution;
}

std::unique_ptr<ReducedMotion> slow_impact(const Scene& scene, const Composition& composition,
                                           const Resolution& resolution) {
  const Bodies& bodies = *composition.bodies;
  return std::make_unique<ReducedMotion>(
      composition.field, start_of(composition, resolution), bodies.compliance->of(bodies.disk()),
      out_of_reach(scene) * impact_energy(scene, 1.0), resolution.step);
}

std::unique_ptr<ModalMotion> modal_impact(const Scene& scene, const Composition& composition,
                                          const Resolution& resolution) {
  const Bodies& bodies = *composition.bodies;
  const ForceField& field = composition.field;
  const auto modes = bodies.modes->of(bodies.disk(), *bodies.compliance, scene.wall.a);
  const ModalCorrection& correction = composition.modal_correction->of([&] {
    return modal_correction({modes, field.bonds.law(), field.wall->repulsion(), nullptr}, field,
                            bodies.all.front().triangles, composition.initial,
                            *bodies.compliance->of(bodies.disk()), scene.numerics.error);
  });
  return std::make_unique<ModalMotion>(field, start_of(composition, resolution), modes, correction,
                                       resolution.lift / scene.impact.normal_velocity(),
                                       resolution.step);
}

}  // namespace impact
