#include "run/error_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "measure/strain.hpp"
#include "mechanics/motion.hpp"
#include "run/expected_time.hpp"
#include "run/forecast.hpp"
#include "run/runs_ahead.hpp"
#include "run/slow_impact.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

constexpr double kMostRefinement = 5.0;  // at once, where an order is seen
constexpr double kMostBlindRefinement = 2.0;
constexpr double kMostSteps = 3e5;
constexpr double kLeastTolerance = 1e-14;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kRoundingOfStrain = 4.0;  // of ξ over ε R
/// The part of numerics.error above which the wall's tail is made smaller.
constexpr double kMostTail = 0.1;
constexpr double kStagnation = 0.7;
constexpr int kMostFailures = 4;
/// Of steps, after which plans are given up.
constexpr int kMostPlansAfterHalving = 3;

}  // namespace

ErrorControl::ErrorControl(Scene scene, const Composition& composition)
    : scene_(std::move(scene)),
      rates_(composition.rates),
      expected_time_(composition.expected_time),
      resolution_(composition.resolution),
      points_(composition.bodies->disk().points.rows()),
      estimate_(scene_, composition.rates.spacing) {
  if (is_controlled()) plan(resolution_);
}

bool ErrorControl::is_controlled() const {
  return scene_.kind == SceneKind::kCollision && !scene_.numerics.are_given();
}

/// Runs that lead up to this one.
void ErrorControl::plan(const Resolution& finest) {
  planned_ = leading_up_to(scene_, finest);
  estimate_.clear();
  rates_.modal = rates_.modal && finest.integrator == IntegratorKind::kModal;
  rates_.imex = rates_.modal || (rates_.imex && finest.integrator == IntegratorKind::kImex);
  most_steps_ = std::max({most_steps_, kMostSteps, kMostRefinement * expected_time_ / finest.step});
  go_on(kRefinement);
}

/// By the stiffness that the wall was seen to have. Where that does not explain the halving, or has
/// been tried several times, just by shorter steps.
void ErrorControl::plan_after_halving(const FinishedImpact& run) {
  rates_.met = run.stiffest_contact / Motion::wall_margin(solves_for_bonds(resolution_.integrator));
  Resolution next = first_resolution(scene_, rates_);
  next.lift = resolution_.lift;
  const double longest = leading_up_to(scene_, next).back().step;
  if (next.step > 0.0 && longest < resolution_.step && expected_time_ / next.step <= most_steps_ &&
      ++halvings_ <= kMostPlansAfterHalving) {
    plan(next);
    return;
  }
  resolution_.step = run.step;
  estimate_.clear();
  planned_.clear();
  refine(kRefinement);
}

void ErrorControl::go_on(double factor) {
  if (planned_.empty()) {
    refine(factor);
  } else {
    resolution_ = planned_.back();
    planned_.pop_back();
  }
}

std::vector<Resolution> ErrorControl::later_resolutions() const {
  return {planned_.rbegin(), planned_.rend()};
}

bool ErrorControl::accepts(const Run& run, const Restitution& measured) {
  if (scene_.kind == SceneKind::kCollision) {
    FinishedImpact impact =
        finished_impact(run, is_controlled() ? after_the_tail(run, measured) : measured);
    if (is_controlled()) impact.model_error = model_error_of(run);
    return accepts(impact);
  }
  accepted_ = scene_.kind != SceneKind::kContact || accepts_contact(run);
  return accepted_;
}

void ErrorControl::find_resolution(const std::shared_ptr<const Composition>& composition,
                                   const std::function<bool()>& stop) {
  if (!is_controlled()) return;
  RunsAhead ahead(scene_, composition);
  while (!accepted_ && !stop()) {
    ImpactAnalysis analysis(scene_.gravity);
    show(composition->field, start_of(*composition, resolution_), analysis);
    ahead.begin(resolution_, later_resolutions());
    Run run = ahead.take(resolution_, stop);
    try {
      while (!run.finished() && !stop()) run.advance(stop);
      run.show(analysis);
      analysis.add(run.take_contact_reports().on_first);
      if (run.finished()) accepts(run, analysis.restitution(true));
    } catch (const RunFailure& failure) {
      take_failure(failure);
    }
  }
}

bool ErrorControl::accepts(const FinishedImpact& run) {
  if (!is_controlled()) {
    estimate_.take(run.measured);
    accepted_ = true;
    return true;
  }
  if (run.not_separated) {
    give_up(fmt::format("the disk had not left the wall for good after {:.3g} R/c", run.time));
  }
  if (run.step_reduced) {
    plan_after_halving(run);
    return false;
  }
  if (leaves_out_too_much(run)) return false;
  estimate_.note_irregularities(run);
  if (starts_too_near(run)) return false;
  estimate_.add(resolution_, run.measured);
  if (!planned_.empty() || !estimate_.is_enough()) {
    go_on(kRefinement);
    return false;
  }
  estimate_.conclude(run);
  estimated_error_ = estimate_.error();
  accepted_ = estimate_.is_good() && !estimate_.may_agree_by_chance(run);
  if (accepted_) return true;
  if (estimate_.is_good() || estimate_.are_pair()) {
    shorten(kRefinement);
  } else {
    refine_by_estimate();
  }
  return false;
}

/// True when the next run will start higher. A fold may turn on what the wall holds at the start:
/// one scene of 2000 made of it 2·10⁴ times as much.
bool ErrorControl::starts_too_near(const FinishedImpact& run) {
  constexpr double kLessBeforeFolds = 1e-4;
  if (scene_.impact.gap) return false;
  const double most = kMostTail * scene_.numerics.error;
  const bool begins_to_fold = run.folded && !is_lifted_for_folds_;
  if (run.tail_error <= most && !begins_to_fold) return false;
  double fewer = std::max(1.0, 2.0 * run.tail_error / most);
  if (begins_to_fold) fewer /= kLessBeforeFolds;
  is_lifted_for_folds_ = is_lifted_for_folds_ || begins_to_fold;
  Resolution finest = planned_.empty() ? resolution_ : planned_.front();
  finest.lift += on_whole_resets(scene_, std::log(fewer) / scene_.wall.a);
  plan(finest);
  return true;
}

/// It does not depend on the step: the first run of a method says it.
const ModelError& ErrorControl::model_error_of(const Run& run) {
  if (estimate_.is_empty()) model_error_ = run.system().model_error();
  return model_error_;
}

/// True when the next run will move all points.
bool ErrorControl::leaves_out_too_much(const FinishedImpact& run) {
  double left_out = run.model_error.restitution;
  if (scene_.impact.slides()) {
    left_out =
        std::max(left_out, run.model_error.spin / std::abs(scene_.impact.tangential_velocity()));
  }
  const bool too_much = !(left_out <= kMostLeftOut * scene_.numerics.error);
  const bool may_fold =
      moves_less_than_all(resolution_.integrator) && (run.folded || run.model_error.may_fold);
  if (!too_much && !may_fold) return false;
  if (!go_on_otherwise()) {
    give_up(too_much
                ? fmt::format("what it leaves out may change the answer by {:.1e}", left_out)
                : "the lattice may fold: a triangle of it is pressed to two thirds of its area");
  }
  return true;
}

/// Where `auto` began with a method for slow impacts, by one for all. False if it did not, or if
/// that would take too long.
bool ErrorControl::go_on_otherwise() {
  const IntegratorKind present = resolution_.integrator;
  const bool is_slow = moves_less_than_all(present) || present == IntegratorKind::kImex;
  if (!is_slow || scene_.numerics.integrator != IntegratorKind::kAuto) return false;
  rates_.imex = present == IntegratorKind::kModal;
  rates_.modal = false;
  rates_.met.reset();
  Resolution next = first_resolution(scene_, rates_);
  Scene with_next = scene_;
  with_next.numerics.integrator = next.integrator;
  if (forecast(with_next, points_, 0).seconds > scene_.numerics.longest) return false;
  next.lift = resolution_.lift;
  failures_ = halvings_ = stagnations_ = 0;
  last_estimate_ = std::numeric_limits<double>::infinity();
  plan(next);
  return true;
}

void ErrorControl::refine_by_estimate() {
  stagnations_ = estimated_error_ > kStagnation * last_estimate_ ? stagnations_ + 1 : 0;
  last_estimate_ = estimated_error_;
  const bool adaptive = is_adaptive(resolution_.integrator);
  if (stagnations_ + 1 >=
      static_cast<int>(std::max(estimate_.runs_needed(), kRunsThatShowAnOrder))) {
    if (go_on_otherwise()) return;
    give_up(fmt::format("finer {} do not bring the error of the restitution below {:.1e}{}",
                        adaptive ? "tolerances" : "steps", estimated_error_,
                        estimate_.likely_cause()));
  }
  const double excess = 2.0 * estimated_error_ / scene_.numerics.error;
  const double power = adaptive                      ? kToleranceOrder
                       : estimate_.is_extrapolated() ? order_of(resolution_.integrator) + 2
                                                     : order_of(resolution_.integrator);
  const double factor = estimate_.may_be_confirmed()
                            ? kRefinement
                            : std::max(kRefinement, std::pow(excess, 1.0 / power));
  if (go_over(resolution_.step / factor)) return;
  shorten(std::min(factor, estimate_.is_extrapolated() ? kMostRefinement : kMostBlindRefinement));
}

bool ErrorControl::accepts_contact(const Run& run) {
  const StrainMeter meter(run.lattice().points);
  const PointArray position = run.disk_state().position;
  const double strain = meter.measure(position).strain();
  const double corrected = meter.measure(position + run.correction()).strain();
  estimated_error_ =
      (std::abs(corrected - strain) + kRoundingOfStrain * kEpsilon) / std::abs(corrected);
  if (scene_.numerics.are_given()) return true;
  if (run.has_flag(Flag::kNotAtRest)) give_up("no state of rest was found");
  if (estimated_error_ > scene_.numerics.error) {
    give_up(
        fmt::format("the disk came to rest, but rounding leaves an error of {:.1e} in its strain",
                    estimated_error_));
  }
  return true;
}

void ErrorControl::take_failure(const RunFailure& failure) {
  if (!is_controlled()) throw failure;
  if (go_on_otherwise()) return;
  if (++failures_ > kMostFailures) throw failure;
  estimate_.clear();
  planned_.clear();
  refine(2.0);
}

/// To a method of higher order, or from one for slow impacts to others, if it costs less than this
/// step (R/c) of the present one.
bool ErrorControl::go_over(double step) {
  const auto better = better_integrator(scene_, resolution_, step, rates_);
  if (!better) return false;
  last_estimate_ = std::numeric_limits<double>::infinity();
  plan(*better);
  return true;
}

void ErrorControl::refine(double factor) {
  if (!go_over(resolution_.step / factor)) shorten(factor);
}

void ErrorControl::shorten(double factor) {
  resolution_ = finer(scene_, resolution_, factor);
  if (is_adaptive(resolution_.integrator)) {
    if (resolution_.tolerance < kLeastTolerance) {
      give_up(fmt::format("a tolerance below {:g} would be needed", kLeastTolerance));
    }
  } else if (expected_time_ / resolution_.step > most_steps_ && !go_on_otherwise()) {
    give_up(fmt::format("a step of {:.2g} R/c, more than {:.2g} steps, would be needed{}",
                        resolution_.step, most_steps_, estimate_.likely_cause()));
  }
}

void ErrorControl::give_up(const std::string& cause) const {
  throw RunFailure(fmt::format("numerics.error: {} cannot be kept by {}: {}", scene_.numerics.error,
                               name_of(resolution_.integrator), cause));
}

}  // namespace impact
