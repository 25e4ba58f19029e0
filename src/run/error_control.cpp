#include "run/error_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "measure/strain.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

constexpr double kLeastRefinement = 1.3;
constexpr double kMostRefinement = 5.0;  // at once
constexpr double kMargin = 2.0;
constexpr double kTail = 0.01;  // of numerics.error
constexpr double kMostSteps = 3e5;
constexpr double kLeastTolerance = 1e-14;
/// Refinements that may leave the estimate as it is before the cause is taken to be another one.
constexpr int kMostStagnations = 2;
constexpr double kStagnation = 0.7;

/// The order by which errors are expected to fall. Stiff damping takes half of it from
/// extrapolation (order reduction): 3 … 4 were seen.
int expected_order(const Resolution& resolution, const Rates& rates) {
  const bool stiff = rates.lattice.gamma * resolution.step > 1.0;
  return stiff && resolution.integrator == IntegratorKind::kExtrapolatedDamping
             ? 3
             : order_of(resolution.integrator);
}

double relative_difference(const Eigen::Array2d& a, const Eigen::Array2d& b) {
  return (a - b).matrix().norm() / a.matrix().norm();
}

}  // namespace

ErrorControl::ErrorControl(Scene scene, const Composition& composition)
    : scene_(std::move(scene)),
      rates_(composition.rates),
      expected_time_(composition.expected_time),
      resolution_(composition.resolution),
      most_steps_(std::max(kMostSteps, kMostRefinement * expected_time_ / resolution_.step)) {}

bool ErrorControl::accepts(const Run& run) {
  switch (scene_.kind) {
    case SceneKind::kCollision:
      return scene_.numerics.are_given() || accepts_impact(run);
    case SceneKind::kContact:
      return accepts_contact(run);
    default:
      return true;
  }
}

std::optional<Resolution> ErrorControl::second_resolution() const {
  if (scene_.kind != SceneKind::kCollision || scene_.numerics.are_given()) return std::nullopt;
  ErrorControl later = *this;
  try {
    later.refine(kLeastRefinement);
  } catch (const RunFailure&) {
    return std::nullopt;
  }
  return later.resolution_;
}

void ErrorControl::find_resolution(const std::shared_ptr<const Composition>& composition,
                                   const std::function<bool()>& stop) {
  if (scene_.kind != SceneKind::kCollision || scene_.numerics.are_given()) return;
  for (bool accepted = false; !accepted && !stop();) {
    Run run(scene_, composition, resolution_);
    try {
      while (!run.finished() && !stop()) run.advance(stop);
      accepted = run.finished() && accepts(run);
    } catch (const RunFailure& failure) {
      take_failure(failure);
    }
  }
}

bool ErrorControl::accepts_impact(const Run& run) {
  if (run.has_flag("not_separated")) {
    give_up(
        fmt::format("the disk had not left the wall for good after {:.3g} R/c, {} times the "
                    "expected duration",
                    run.state().time, Run::kPatience));
  }
  const bool reduced = run.motion().halvings() > 0;
  resolution_.step = run.motion().step_size();
  const Answer answer{resolution_, run.disk_state().velocity.colwise().mean()};
  if (!last_ || last_->resolution.integrator != resolution_.integrator || reduced) {
    last_ = answer;
    refine(kLeastRefinement);
    return false;
  }
  unruly_ = unruly_ || run.has_flag("folded");
  const double difference = relative_difference(answer.velocity, last_->velocity);
  const bool adaptive = is_adaptive(resolution_.integrator);
  const int order = expected_order(resolution_, rates_);
  const double gain =
      adaptive ? kMargin : std::pow(last_->resolution.step / resolution_.step, order) - 1.0;
  const double estimate = kMargin * difference / gain;
  estimated_error_ = estimate + kTail * scene_.numerics.error;
  last_ = answer;
  const bool good = estimated_error_ <= scene_.numerics.error;
  if (good && (!unruly_ || last_was_good_)) return true;
  last_was_good_ = good;
  if (good) {
    refine(kLeastRefinement);
    return false;
  }

  unruly_ = unruly_ || std::isfinite(last_estimate_);
  stagnations_ = estimate > kStagnation * last_estimate_ ? stagnations_ + 1 : 0;
  last_estimate_ = estimate;
  if (stagnations_ >= kMostStagnations) {
    give_up(fmt::format("finer {} do not bring the error of the restitution below {:.1e}{}",
                        adaptive ? "tolerances" : "steps", estimated_error_,
                        run.has_flag("folded") ? ": the lattice folds"
                        : run.has_flag("hops") ? ": contacts hop from bond to bond"
                                               : ""));
  }
  const double wanted =
      std::pow(2.0 * estimate / scene_.numerics.error, adaptive ? 0.25 : 1.0 / order);
  refine(std::clamp(wanted, kLeastRefinement, kMostRefinement));
  return false;
}

bool ErrorControl::accepts_contact(const Run& run) {
  const StrainMeter meter(run.lattice().points);
  const PointArray position = run.disk_state().position;
  const double strain = meter.measure(position).strain();
  const double corrected = meter.measure(position + run.correction()).strain();
  estimated_error_ = std::abs(corrected - strain) / std::abs(corrected);
  if (scene_.numerics.are_given()) return true;
  if (run.has_flag("not_at_rest")) give_up("no state of rest was found");
  if (estimated_error_ > scene_.numerics.error) {
    give_up(
        fmt::format("the disk came to rest, but rounding leaves an error of {:.1e} in its strain",
                    estimated_error_));
  }
  return true;
}

void ErrorControl::take_failure(const RunFailure& failure) {
  if (scene_.kind != SceneKind::kCollision || scene_.numerics.are_given()) throw failure;
  if (++stagnations_ > 2 * kMostStagnations) throw failure;
  last_.reset();
  refine(2.0);
}

void ErrorControl::refine(double wanted_factor) {
  const double step = resolution_.step / wanted_factor;
  if (const auto better = better_integrator(scene_, resolution_, step, rates_)) {
    resolution_ = *better;
    last_estimate_ = std::numeric_limits<double>::infinity();
    return;
  }
  resolution_ = finer(scene_, resolution_, wanted_factor);
  if (is_adaptive(resolution_.integrator)) {
    if (resolution_.tolerance < kLeastTolerance) {
      give_up(fmt::format("a tolerance below {:g} would be needed", kLeastTolerance));
    }
  } else if (expected_time_ / resolution_.step > most_steps_) {
    give_up(fmt::format("a step of {:.2g} R/c, more than {:.2g} steps, would be needed",
                        resolution_.step, most_steps_));
  }
}

void ErrorControl::give_up(const std::string& cause) const {
  throw RunFailure(fmt::format("numerics.error: {} cannot be kept by {}: {}", scene_.numerics.error,
                               name_of(resolution_.integrator), cause));
}

}  // namespace impact
