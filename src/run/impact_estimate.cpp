#include "run/impact_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace impact {
namespace {

/// Of e over √steps.
constexpr double kRoundingOfImpact = 16.0 * std::numeric_limits<double>::epsilon();
constexpr std::size_t kRunsToCompare = 3;
constexpr std::size_t kErraticRunsToCompare = 5;
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

/// What vanishes with the error of a run.
double step_of(const Resolution& resolution) {
  return is_adaptive(resolution.integrator) ? std::sqrt(resolution.tolerance) : resolution.step;
}

}  // namespace

ImpactEstimate::ImpactEstimate(Scene scene, double spacing)
    : scene_(std::move(scene)), spacing_(spacing) {}

void ImpactEstimate::note_irregularities(const FinishedImpact& run) {
  erratic_ = erratic_ || run.folded || run.cut_off;
  irregular_ = irregular_ || run.error_by_hops > scene_.numerics.error;
  likely_cause_ = run.folded    ? ": the lattice folds"
                  : run.cut_off ? ": the wall is cut off at wall.threshold"
                  : irregular_  ? ": contacts hop from bond to bond"
                                : "";
}

void ImpactEstimate::take(const Restitution& measured) { answer_ = {measured, {}}; }

std::size_t ImpactEstimate::runs_needed() const {
  return erratic_ ? kErraticRunsToCompare : kRunsToCompare;
}

bool ImpactEstimate::is_enough() const { return runs_.size() >= runs_needed() || are_pair(); }

/// Of e, relative. Solutions for the damped velocities are off to one side.
double ImpactEstimate::rounding(const FinishedImpact& run) const {
  const auto steps = static_cast<double>(run.steps);
  return kRoundingOfImpact * (solves_for_damping(integrator()) ? steps : std::sqrt(steps));
}

/// How far the disk comes in a step (R/c), in ranges 1/a of the wall.
double ImpactEstimate::way_in(double step) const { return scene_.wall_rate() * step; }

/// The order that the latest runs may show.
std::optional<int> ImpactEstimate::order() const {
  const double longest_way =
      way_in(runs_[runs_.size() - std::min(runs_.size(), kRunsToCompare)].resolution.step);
  const bool begins_off =
      integrator() == IntegratorKind::kTakahashiImada && !scene_.flies_without_forces();
  if (erratic_ || irregular_ || begins_off || longest_way > kLongestResolvedWay ||
      is_adaptive(integrator())) {
    return std::nullopt;
  }
  return order_of(integrator());
}

bool ImpactEstimate::are_pair() const {
  return runs_.size() == 2 && order() && in_half_steps(runs_[0].resolution, runs_[1].resolution);
}

ConvergedValue ImpactEstimate::convergence_of(const std::vector<Sample>& runs) const {
  if (const auto p = order()) return runs.size() == 2 ? compared(runs, *p) : converged(runs, *p);
  return erratic_ && !is_adaptive(integrator()) ? compared_if_all_fall(runs, order_of(integrator()))
                                                : compared_with_scatter(runs);
}

void ImpactEstimate::conclude(const FinishedImpact& latest) {
  noise_ = latest.tail_error + latest.error_by_hops * std::min(1.0, way_in(latest.step)) +
           rounding(latest);
  left_out_ = latest.model_error.restitution;
  const std::size_t count = std::min(runs_.size(), order() ? kRunsThatShowAnOrder : runs_needed());
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
    answer_.error.*number = estimate.error + noise_ * std::abs(estimate.value);
  }
  add(latest.model_error);
  const double e = answer_.value.restitution;
  answer_.value.velocity_after = -e * finest.velocity_before;
  answer_.error.velocity_after = answer_.error.restitution * std::abs(finest.velocity_before);
  answer_.error_of_run = std::abs(finest.restitution - e) + answer_.error.restitution;
  error_ = greatest_error();
  if (is_good()) add_lost_of_spin(latest.lost_of_spin);
}

double ImpactEstimate::greatest_error() const {
  double greatest = answer_.error.restitution / std::abs(answer_.value.restitution);
  if (scene_.is_row()) greatest = std::max(greatest, answer_.error.momentum_passed_on);
  if (!scene_.impact.slides()) return greatest;
  if (std::isfinite(answer_.value.tangential_restitution)) {
    greatest = std::max(greatest, answer_.error.tangential_restitution);
  }
  const double surface_speed = scene_.impact.velocity + std::abs(scene_.impact.spin);
  return std::max(greatest, answer_.error.spin_after / surface_speed);
}

bool ImpactEstimate::is_good() const {
  const double wanted = scene_.numerics.error;
  const double by_steps = error_ - left_out_;
  if (!(error_ <= wanted)) return false;
  if (are_pair()) return by_steps - noise_ <= kPairAgrees * wanted;
  const double part = !is_extrapolated() ? 1.0 : is_confirmed() ? kConfirmedLimit : kUnconfirmed;
  return by_steps <= part * wanted;
}

/// To the errors of the answer.
void ImpactEstimate::add(const ModelError& left_out) {
  for (const auto& [name, number] : impact_numbers<Restitution>()) {
    const double relative = is_read_off_steps(name) ? left_out.others : left_out.restitution;
    answer_.error.*number += relative * std::abs(answer_.value.*number);
  }
  if (!moves_less_than_all(integrator())) return;
  const double turned = left_out.spin / std::abs(answer_.value.spin_after);
  answer_.error.spin_after += left_out.spin;
  answer_.error.rotation_energy += 2.0 * turned * answer_.value.rotation_energy;
  answer_.error.tangential_restitution +=
      left_out.spin / std::abs(scene_.impact.tangential_velocity());
}

/// To the errors of what depends on the spin: this part of it may be lost between the end of the
/// contact and that of the run, but no more than the energy that is not seen at the end. It is no
/// error of the runs, so that no finer ones are made for it.
void ImpactEstimate::add_lost_of_spin(double lost) {
  if (lost == 0.0) return;
  const Restitution& value = answer_.value;
  Restitution& error = answer_.error;
  const double unseen =
      std::max(0.0, 1.0 - value.normal_energy - value.tangential_energy - value.rotation_energy);
  const double energy = std::min(unseen, lost * (2.0 + lost) * value.rotation_energy);
  const double spin = std::abs(value.spin_after);
  const double more_spin =
      std::sqrt(spin * spin + 2.0 * energy * value.energy_before / value.moment_of_inertia) - spin;
  error.spin_after += more_spin;
  error.rotation_energy += energy;
  error.energy_restitution += 0.5 * energy / value.energy_restitution;
  error.tangential_restitution +=
      more_spin / std::abs(value.tangential_velocity_before + value.spin_before);
  error.wall_spin_after += lost * std::abs(value.wall_spin_after);
  error.wall2_spin_after += lost * std::abs(value.wall2_spin_after);
  error.wall3_spin_after += lost * std::abs(value.wall3_spin_after);
}

bool ImpactEstimate::is_extrapolated() const {
  return answer_.value.restitution != runs_.back().measured.restitution;
}

/// A limit of three runs alone may be off by several times its estimate, one in a hundred is.
bool ImpactEstimate::is_confirmed() const {
  return !is_extrapolated() || runs_.size() >= kRunsThatShowAnOrder;
}

/// Limits agree by chance now and then: those of four runs once in 2000 random
/// scenes to 10⁻⁵ of what was extrapolated, when they were off by 10⁻³ of it. Three have nothing to
/// say of the term after the two that they are fitted to. Of a spring of frequency ω over the point
/// mass it is (ω² h₁ h₂)²/60 of the first, by Verlet, cos ω′h = 1 − ω²h²/2, as well as by
/// Takahashi–Imada, 1 − ω²h²/2 (1 − ω²h²/12), with h₁ and h₂ the longer steps; the stiffest is that
/// of the wall. Where that is hard over the spacing of the points, errors do not follow one curve:
/// all that three runs extrapolate is in doubt.
bool ImpactEstimate::may_agree_by_chance(const FinishedImpact& finest) const {
  constexpr double kDoubtful = 2e-3;
  if (!is_extrapolated() || runs_.size() > kRunsThatShowAnOrder) return false;
  double doubtful = kDoubtful;
  if (!is_confirmed()) {
    const double longer = runs_[0].resolution.step * runs_[1].resolution.step;
    doubtful = scene_.wall.a * spacing_ > kHardOverSpacing
                   ? 1.0
                   : std::max(doubtful, std::pow(finest.stiffest_contact * longer, 2) / 60.0);
  }
  const double taken_out = answer_.value.restitution - finest.measured.restitution;
  return doubtful * std::abs(taken_out) >
         scene_.numerics.error * std::abs(answer_.value.restitution);
}

bool ImpactEstimate::may_be_confirmed() const {
  if (is_extrapolated() || !order() || runs_.size() + 1 != kRunsThatShowAnOrder) return false;
  const auto sample = [this](std::size_t k) {
    return Sample{step_of(runs_[k].resolution), runs_[k].measured.restitution};
  };
  return may_show_order(sample(0), sample(1), sample(2), *order());
}

}  // namespace impact
