#include "run/error_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "measure/strain.hpp"
#include "mechanics/rotation_hold.hpp"
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
/// Rounding of e over ε √steps, and of ξ over ε R.
constexpr double kRoundingOfImpact = 16.0;
constexpr double kRoundingOfStrain = 4.0;
/// The part of numerics.error above which the wall's tail is made smaller.
constexpr double kMostTail = 0.1;
constexpr double kStagnation = 0.7;
constexpr std::size_t kRunsToCompare = 3;
constexpr std::size_t kErraticRunsToCompare = 5;
constexpr std::size_t kRunsThatShowAnOrder = 4;
/// The largest estimate, but for what a model leaves out, over numerics.error, that is accepted of
/// a limit: without a fourth run, and with it.
constexpr double kUnconfirmed = 0.1;
constexpr double kConfirmedLimit = 0.5;
/// Of numerics.error: by how much two runs, the second in half the steps of the first, may differ
/// for no third to be needed.
constexpr double kPairAgrees = 0.02;
/// a s, s the spacing of the points: above it they meet the wall one after another (16 on the
/// default disk).
constexpr double kHardOverSpacing = 50.0;
constexpr int kMostFailures = 4;
/// Of steps, after which plans are given up.
constexpr int kMostPlansAfterHalving = 3;

/// What vanishes with the error of a run.
double step_of(const Resolution& resolution) {
  return is_adaptive(resolution.integrator) ? std::sqrt(resolution.tolerance) : resolution.step;
}

/// What is measured when the disk has left for good too: the wall's energy U that is left at the
/// end of a run still adds U/v′ to the velocity v′ of the disk (M = 1, U ≪ v′²), of which it is μ
/// times as much where another disk flies away too, and U to the energy of all.
Restitution after_the_tail(const Run& run, Restitution measured) {
  const double energy = run.system().field().wall_potential_energy(run.state().position);
  const double gain = run.system().field().reduced_mass() * energy / measured.velocity_after;
  measured.velocity_after += gain;
  measured.restitution = -measured.velocity_after / measured.velocity_before;
  measured.impulse += gain;
  const double part = energy / measured.energy_before;
  measured.normal_energy += part;
  measured.energy_restitution =
      std::sqrt(measured.energy_restitution * measured.energy_restitution + part);
  return measured;
}

/// Of the spin of the disk, relative, in this time (R/c) of flight. The damping acts on what turns:
/// I ω′ = −ω Σ η d², with the lengths d of the bonds.
double lost_of_spin(const Run& run, double time) {
  const ForceField& field = run.system().field();
  if (!field.bonds.damped()) return 0.0;
  const Body disk = field.first_body();
  const RotationHold rotation(disk.rows_of(run.state().position));
  PointArray velocity = PointArray::Zero(field.bonds.points(), 2);
  velocity.middleRows(disk.first, disk.points) = rotation.direction();
  PointArray force(velocity.rows(), 2);
  const double power = BondForces(field.bonds).evaluate_damping(velocity, force);
  const double inertia = field.point_mass * rotation.direction().square().sum();
  return std::expm1(power / inertia * time);
}

FinishedImpact finished_impact(const Run& run, const Restitution& measured) {
  FinishedImpact impact;
  impact.measured = measured;
  impact.step = run.system().step_size();
  impact.steps = run.state().step;
  impact.time = run.state().time;
  impact.tail_error = run.tail_error();
  const ForceField& field = run.system().field();
  const Contact& contact = *field.contact();
  impact.error_by_hops =
      0.5 * (contact.hops_size() + contact.turned()) / field.impact_energy(measured.velocity_after);
  impact.step_reduced = run.system().halvings() > 0;
  impact.stiffest_contact = run.system().stiffest_contact();
  impact.lost_of_spin = lost_of_spin(run, std::max(0.0, impact.time - measured.contact_end));
  impact.not_separated = run.has_flag(Flag::kNotSeparated);
  impact.folded = run.has_flag(Flag::kFolded);
  impact.cut_off = run.has_flag(Flag::kCutOff);
  return impact;
}

}  // namespace

ErrorControl::ErrorControl(Scene scene, const Composition& composition)
    : scene_(std::move(scene)),
      rates_(composition.rates),
      expected_time_(composition.expected_time),
      resolution_(composition.resolution),
      points_(composition.bodies->disk().points.rows()) {
  if (is_controlled()) plan(resolution_);
}

bool ErrorControl::is_controlled() const {
  return scene_.kind == SceneKind::kCollision && !scene_.numerics.are_given();
}

/// Runs that lead up to this one.
void ErrorControl::plan(const Resolution& finest) {
  planned_ = leading_up_to(scene_, finest);
  runs_.clear();
  rates_.modal = rates_.modal && finest.integrator == IntegratorKind::kModal;
  rates_.imex = rates_.modal || (rates_.imex && finest.integrator == IntegratorKind::kImex);
  most_steps_ = std::max({most_steps_, kMostSteps, kMostRefinement * expected_time_ / finest.step});
  go_on(kRefinement);
}

/// By the stiffness that the wall was seen to have. Where that does not explain the halving, or has
/// been tried several times, just by shorter steps.
void ErrorControl::plan_after_halving(const FinishedImpact& run) {
  rates_.met = run.stiffest_contact;
  Resolution next = first_resolution(scene_, rates_);
  next.lift = resolution_.lift;
  const double longest = leading_up_to(scene_, next).back().step;
  if (next.step > 0.0 && longest < resolution_.step && expected_time_ / next.step <= most_steps_ &&
      ++halvings_ <= kMostPlansAfterHalving) {
    plan(next);
    return;
  }
  resolution_.step = run.step;
  runs_.clear();
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
    answer_ = {run.measured, {}};
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
  note_irregularities(run);
  if (starts_too_near(run)) return false;
  runs_.push_back({resolution_, run.measured});
  const bool is_pair = are_pair();
  if (!is_pair && (runs_.size() < runs_needed() || !planned_.empty())) {
    go_on(kRefinement);
    return false;
  }
  const double noise =
      run.tail_error + run.error_by_hops * std::min(1.0, way_in(run.step)) + rounding(run);
  conclude(noise, run.model_error);
  const double error = scene_.numerics.error;
  const double by_steps = estimated_error_ - run.model_error.restitution;
  if (is_pair) {
    accepted_ = estimated_error_ <= error && by_steps - noise <= kPairAgrees * error;
    if (!accepted_) go_on(kRefinement);
  } else {
    const double part = !is_extrapolated() ? 1.0 : is_confirmed() ? kConfirmedLimit : kUnconfirmed;
    accepted_ = estimated_error_ <= error && by_steps <= part * error;
    if (!accepted_) {
      refine_by_estimate();
    } else if (may_agree_by_chance(run)) {
      accepted_ = false;
      shorten(kRefinement);
    }
  }
  if (accepted_) add_lost_of_spin(run.lost_of_spin);
  return accepted_;
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
  if (runs_.empty()) model_error_ = run.system().model_error();
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

void ErrorControl::note_irregularities(const FinishedImpact& run) {
  erratic_ = erratic_ || run.folded || run.cut_off;
  irregular_ = irregular_ || run.error_by_hops > scene_.numerics.error;
  likely_cause_ = run.folded    ? ": the lattice folds"
                  : run.cut_off ? ": the wall is cut off at wall.threshold"
                  : irregular_  ? ": contacts hop from bond to bond"
                                : "";
}

std::size_t ErrorControl::runs_needed() const {
  return erratic_ ? kErraticRunsToCompare : kRunsToCompare;
}

/// Of e, relative. Solutions for the damped velocities are off to one side.
double ErrorControl::rounding(const FinishedImpact& run) const {
  const auto steps = static_cast<double>(run.steps);
  return kRoundingOfImpact * kEpsilon *
         (solves_for_damping(resolution_.integrator) ? steps : std::sqrt(steps));
}

/// How far the disk comes in a step (R/c), in ranges 1/a of the wall.
double ErrorControl::way_in(double step) const {
  return scene_.wall.a * scene_.impact.approach_velocity() * step;
}

/// The order that the latest runs may show.
std::optional<int> ErrorControl::order() const {
  const double longest_way =
      way_in(runs_[runs_.size() - std::min(runs_.size(), kRunsToCompare)].resolution.step);
  const bool begins_off =
      resolution_.integrator == IntegratorKind::kTakahashiImada && !scene_.flies_without_forces();
  if (erratic_ || irregular_ || begins_off || longest_way > kLongestResolvedWay ||
      is_adaptive(resolution_.integrator)) {
    return std::nullopt;
  }
  return order_of(resolution_.integrator);
}

/// Two runs that may bear each other out, since one has at least twice as many steps.
bool ErrorControl::are_pair() const {
  return runs_.size() == 2 && planned_.empty() && order() &&
         in_half_steps(runs_[0].resolution, runs_[1].resolution);
}

ConvergedValue ErrorControl::convergence_of(const std::vector<Sample>& runs) const {
  if (const auto p = order()) return runs.size() == 2 ? compared(runs, *p) : converged(runs, *p);
  return erratic_ && !is_adaptive(resolution_.integrator)
             ? compared_if_all_fall(runs, order_of(resolution_.integrator))
             : compared_with_scatter(runs);
}

/// Finds the answer of the latest runs. `noise`: relative error that finer steps do not take away.
void ErrorControl::conclude(double noise, const ModelError& left_out) {
  const std::size_t count = order() ? std::min(runs_.size(), kRunsThatShowAnOrder) : runs_needed();
  const std::vector<FinishedRun> runs(runs_.end() - static_cast<std::ptrdiff_t>(count),
                                      runs_.end());
  std::vector<Sample> samples;
  samples.reserve(count);
  for (const FinishedRun& run : runs) samples.push_back({step_of(run.resolution), 0.0});
  const Restitution& finest = runs_.back().measured;
  answer_ = {finest, {}};
  for (const auto& [name, number] : impact_numbers<Restitution>()) {
    for (std::size_t k = 0; k < count; ++k) samples[k].value = runs[k].measured.*number;
    const ConvergedValue estimate =
        is_read_off_steps(name) ? compared_with_scatter(samples) : convergence_of(samples);
    answer_.value.*number = estimate.value;
    answer_.error.*number = estimate.error + noise * std::abs(estimate.value);
  }
  add(left_out);
  const double e = answer_.value.restitution;
  answer_.value.velocity_after = -e * finest.velocity_before;
  answer_.error.velocity_after = answer_.error.restitution * std::abs(finest.velocity_before);
  answer_.error_of_run = std::abs(finest.restitution - e) + answer_.error.restitution;
  estimated_error_ = answer_.error.restitution / std::abs(e);
  if (scene_.is_row()) {
    estimated_error_ = std::max(estimated_error_, answer_.error.momentum_passed_on);
  }
  if (!scene_.impact.slides()) return;
  if (std::isfinite(answer_.value.tangential_restitution)) {
    estimated_error_ = std::max(estimated_error_, answer_.error.tangential_restitution);
  }
  const double surface_speed = scene_.impact.velocity + std::abs(scene_.impact.spin);
  estimated_error_ = std::max(estimated_error_, answer_.error.spin_after / surface_speed);
}

/// To the errors of the answer.
void ErrorControl::add(const ModelError& left_out) {
  for (const auto& [name, number] : impact_numbers<Restitution>()) {
    const double relative = is_read_off_steps(name) ? left_out.others : left_out.restitution;
    answer_.error.*number += relative * std::abs(answer_.value.*number);
  }
  if (!moves_less_than_all(resolution_.integrator)) return;
  const double turned = left_out.spin / std::abs(answer_.value.spin_after);
  answer_.error.spin_after += left_out.spin;
  answer_.error.rotation_energy += 2.0 * turned * answer_.value.rotation_energy;
  answer_.error.tangential_restitution +=
      left_out.spin / std::abs(scene_.impact.tangential_velocity());
}

/// To the errors of what depends on the spin: this part of it may be lost between the end of the
/// contact and that of the run. It is no error of the runs, so that no finer ones are made for it.
void ErrorControl::add_lost_of_spin(double lost) {
  if (lost == 0.0) return;
  const Restitution& value = answer_.value;
  Restitution& error = answer_.error;
  const double energy = lost * (2.0 + lost) * value.rotation_energy;
  const double before = value.tangential_velocity_before + value.spin_before;
  error.spin_after += lost * std::abs(value.spin_after);
  error.wall_spin_after += lost * std::abs(value.wall_spin_after);
  error.wall2_spin_after += lost * std::abs(value.wall2_spin_after);
  error.wall3_spin_after += lost * std::abs(value.wall3_spin_after);
  error.rotation_energy += energy;
  error.energy_restitution += 0.5 * energy / value.energy_restitution;
  error.tangential_restitution += lost * std::abs(value.spin_after / before);
}

bool ErrorControl::is_extrapolated() const {
  return answer_.value.restitution != runs_.back().measured.restitution;
}

/// A limit of three runs alone may be off by several times its estimate, one in a hundred is.
bool ErrorControl::is_confirmed() const {
  return !is_extrapolated() || runs_.size() >= kRunsThatShowAnOrder;
}

/// Whether more than numerics.error of what was extrapolated is in doubt, and one more run is to
/// bear the limit out. Limits agree by chance now and then: those of four runs once in 2000 random
/// scenes to 10⁻⁵ of what was extrapolated, when they were off by 10⁻³ of it. Three have nothing to
/// say of the term after the two that they are fitted to. Of a spring of frequency ω over the point
/// mass it is (ω² h₁ h₂)²/60 of the first, by Verlet, cos ω′h = 1 − ω²h²/2, as well as by
/// Takahashi–Imada, 1 − ω²h²/2 (1 − ω²h²/12), with h₁ and h₂ the longer steps; the stiffest is that
/// of the wall. Where that is hard over the spacing of the points, errors do not follow one curve:
/// all that three runs extrapolate is in doubt.
bool ErrorControl::may_agree_by_chance(const FinishedImpact& finest) const {
  constexpr double kDoubtful = 2e-3;
  if (!is_extrapolated() || runs_.size() > kRunsThatShowAnOrder) return false;
  double doubtful = kDoubtful;
  if (!is_confirmed()) {
    const double longer = runs_[0].resolution.step * runs_[1].resolution.step;
    doubtful = scene_.wall.a * rates_.spacing > kHardOverSpacing
                   ? 1.0
                   : std::max(doubtful, std::pow(finest.stiffest_contact * longer, 2) / 60.0);
  }
  const double taken_out = answer_.value.restitution - finest.measured.restitution;
  return doubtful * std::abs(taken_out) >
         scene_.numerics.error * std::abs(answer_.value.restitution);
}

/// Whether a fourth run near the others may show an order that three do not.
bool ErrorControl::may_be_confirmed() const {
  if (is_extrapolated() || !order() || runs_.size() + 1 != kRunsThatShowAnOrder) return false;
  const auto sample = [this](std::size_t k) {
    return Sample{step_of(runs_[k].resolution), runs_[k].measured.restitution};
  };
  return may_show_order(sample(0), sample(1), sample(2), *order());
}

void ErrorControl::refine_by_estimate() {
  stagnations_ = estimated_error_ > kStagnation * last_estimate_ ? stagnations_ + 1 : 0;
  last_estimate_ = estimated_error_;
  const bool adaptive = is_adaptive(resolution_.integrator);
  if (stagnations_ + 1 >= static_cast<int>(std::max(runs_needed(), kRunsThatShowAnOrder))) {
    if (go_on_otherwise()) return;
    give_up(fmt::format("finer {} do not bring the error of the restitution below {:.1e}{}",
                        adaptive ? "tolerances" : "steps", estimated_error_, likely_cause_));
  }
  const double excess = 2.0 * estimated_error_ / scene_.numerics.error;
  const double power = adaptive            ? kToleranceOrder
                       : is_extrapolated() ? order_of(resolution_.integrator) + 2
                                           : order_of(resolution_.integrator);
  const double factor =
      may_be_confirmed() ? kRefinement : std::max(kRefinement, std::pow(excess, 1.0 / power));
  if (go_over(resolution_.step / factor)) return;
  shorten(std::min(factor, is_extrapolated() ? kMostRefinement : kMostBlindRefinement));
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
  runs_.clear();
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
                        resolution_.step, most_steps_, likely_cause_));
  }
}

void ErrorControl::give_up(const std::string& cause) const {
  throw RunFailure(fmt::format("numerics.error: {} cannot be kept by {}: {}", scene_.numerics.error,
                               name_of(resolution_.integrator), cause));
}

}  // namespace impact
