#include "verification/reference_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "mechanics/extrapolated_damping.hpp"
#include "mechanics/implicit_damping.hpp"
#include "mechanics/simulation.hpp"
#include "reference/precise_contact.hpp"
#include "reference/rk8pd.hpp"
#include "run/compose.hpp"
#include "statics/equilibrium_solver.hpp"
#include "verification/random_scene.hpp"

namespace impact {
namespace {

constexpr double kUnknownError = std::numeric_limits<double>::infinity();
/// Of a run, points times force evaluations.
constexpr double kMostWorkOfReference = 3e8;
constexpr std::uint64_t kMostInnerSteps = 10000;  // where some ten are to be expected
constexpr double kGoodEnough = 0.1;               // of the wanted error
/// Of rk8pd: with 10⁻⁴ and 10⁻⁵ two runs of a disk that folds agree by chance.
constexpr double kRoughestTolerance = 1e-6;

class ReferenceFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Knows when the disk has left for good: moving away, and so far that the wall would not change
/// its velocity by more than a thousandth of the wanted error even if the point that was farthest
/// from the centre of mass so far came to lie straight below it, and the wall as high as it ever
/// was.
class Departure {
 public:
  explicit Departure(double error) : error_(error) {}

  bool is_certain(const Motion& motion) {
    const ForceField& field = motion.field();
    const PointArray& position = motion.state().position;
    const Body disk = field.first_body();
    const auto points = disk.rows_of(position);
    const Eigen::Array2d centre = points.colwise().mean();
    const double extent =
        (points.rowwise() - centre.transpose()).square().rowwise().sum().maxCoeff();
    extent_ = std::max(extent_, std::sqrt(extent));
    for (const Body& other : field.others) {
      top_ = std::max(top_, other.rows_of(position).col(1).maxCoeff());
    }
    const double speed = disk.rows_of(motion.state().velocity).col(1).mean();
    if (!(speed > 0.0)) return false;
    const double clearance = centre.y() - extent_ - top_;
    if (clearance > field.contact()->threshold()) return true;
    return field.contact()->potential_at(clearance) < 1e-3 * error_ * 0.5 * speed * speed;
  }

 private:
  double error_;
  double extent_ = 0.0;
  double top_ = 0.0;
};

/// The step that divides the time between resets, if there are any.
double dividing_resets(const ForceField& field, double step) {
  if (!field.velocity_reset) return step;
  const double interval = field.velocity_reset->interval();
  return interval / std::ceil(interval / step);
}

double restitution(const Scene& scene, const Composition& composition, double step,
                   std::unique_ptr<Integrator> integrator) {
  Simulation simulation(composition.field, composition.initial, composition.rates.lattice, step,
                        std::move(integrator));
  Departure departure(scene.numerics.error);
  const auto points = static_cast<double>(composition.initial.position.rows());
  while (!departure.is_certain(simulation)) {
    simulation.step();
    const auto evaluations = static_cast<double>(simulation.field().evaluations);
    if (evaluations * points > kMostWorkOfReference) {
      throw ReferenceFailure(
          fmt::format("the disk has not left the wall after {:.0f} R/c and {:.1e} evaluations",
                      simulation.time(), evaluations));
    }
  }
  const Eigen::Index disk = composition.bodies->disk().points.rows();
  return simulation.state().velocity.col(1).head(disk).mean() / scene.impact.normal_velocity();
}

/// The last of up to four values of rising precision, and how it differs from the one before.
ReferenceAnswer converged(const std::string& method, double wanted_error,
                          const std::function<double(int)>& value) {
  constexpr int kMostValues = 4;
  double last = value(0);
  double error = kUnknownError;
  for (int k = 1; k < kMostValues && !(error <= kGoodEnough * wanted_error); ++k) {
    const double next = value(k);
    error = std::abs(last / next - 1.0);
    last = next;
  }
  return {last, error, method, {}};
}

ReferenceAnswer impact_reference(const Scene& scene) {
  Scene far = scene;
  far.numerics.error *= 1e-3;
  const Composition composition = compose(far);
  const Rates& rates = composition.rates;
  const double omega = std::sqrt(rates.lattice.omega_squared);
  const double error = scene.numerics.error;
  const double on_wall = std::sqrt(rates.lattice.omega_squared + rates.wall);
  if (composition.bodies->is_alone() && rates.lattice.gamma > kStiffDamping * on_wall) {
    const double step = 0.25 / on_wall;
    return converged("extrapolated_damping", error, [&](int k) {
      return restitution(scene, composition, std::ldexp(step, -k),
                         std::make_unique<ExtrapolatedDamping>());
    });
  }
  const double v = scene.impact.normal_velocity();
  const Scales scales{v / rates.sound_speed, v};
  // Below this tolerance rounding of the positions would pass for errors of a step.
  const double least_tolerance = 3e-14 / scales.length;
  const double step = dividing_resets(composition.field, 10.0 / (omega + rates.lattice.gamma));
  return converged("rk8pd", error, [&](int k) {
    const double first =
        std::max(std::min(0.1 * error, kRoughestTolerance), 100.0 * least_tolerance);
    const double tolerance = std::max(first * std::pow(10.0, -k), least_tolerance);
    // Another interval of reports, so that the inner steps differ even where they end at it.
    return restitution(scene, composition, step / (1 + k),
                       std::make_unique<Rk8pd>(tolerance, scales, kMostInnerSteps));
  });
}

PointArray rest_by_newton(const Composition& composition, double tolerance) {
  EquilibriumSearch search(composition.field, composition.initial, tolerance);
  solve(search);
  return search.state().position;
}

/// Damped motion until no static force exceeds a tenth of the load's share of a point.
PointArray rest_by_motion(const Composition& composition, double load) {
  constexpr double kMostTime = 1e4;
  constexpr std::uint64_t kLookSteps = 64;
  const double step = 1.0 / std::sqrt(composition.rates.lattice.omega_squared);
  const auto points = static_cast<double>(composition.initial.position.rows());
  Simulation simulation(composition.field, composition.initial, composition.rates.lattice, step,
                        std::make_unique<ImplicitDamping>());
  do {
    simulation.step();
    if (simulation.time() > kMostTime)
      throw ReferenceFailure("damped motion does not come to rest");
  } while (simulation.steps() % kLookSteps != 0 ||
           simulation.largest_static_force() > 0.1 * load / points);
  return simulation.state().position;
}

ReferenceAnswer contact_reference(const Scene& scene) {
  constexpr double kSmallLoad = 1e-3;  // of k_a R
  const double load = scene.load.p;
  Scene damped = scene;
  damped.numerics.integrator = IntegratorKind::kImplicitDamping;
  damped.material.eta = scene.disk.recipe.points * std::sqrt(scene.material.k_a);
  const Composition composition = compose(damped);
  const BondLaw law{scene.material.k_a, scene.material.k_b, 0.0};
  const PressedDisk disk{composition.bodies->disk(), law, scene.wall.a, load};
  const double tolerance = 1e-6 * load / scene.disk.recipe.points;
  const PreciseStrain strain = precise_strain(disk, rest_by_newton(composition, tolerance));
  if (load <= kSmallLoad * scene.material.k_a) return {strain.value, strain.error, "newton", {}};
  const PreciseStrain other = precise_strain(disk, rest_by_motion(composition, load));
  const double difference = std::abs(strain.value / other.value - 1.0);
  return {other.value, std::max(other.error, difference), "motion", {}};
}

}  // namespace

ReferenceAnswer reference_answer(const Scene& scene) {
  try {
    return scene.kind == SceneKind::kContact ? contact_reference(scene) : impact_reference(scene);
  } catch (const std::exception& failure) {
    return {std::nan(""), kUnknownError, {}, failure.what()};
  }
}

}  // namespace impact
