#include "run/convergence.hpp"

#include <algorithm>
#include <cmath>

namespace impact {
namespace {

constexpr double kBelow = 0.25;  // of a power
constexpr double kAbove = 0.5;
constexpr double kFarBelow = 1.0;  // where four runs say it
/// Of the last correction, which counts in full as long as no fourth run confirms it.
constexpr double kConfirmed = 0.15;
constexpr double kNextMargin = 3.0;
constexpr double kLeastDoubt = 0.05;

/// (v₁ − v₂)/(v₂ − v₃) of values with the error hᵖ.
double ratio_of_order(const Sample& coarse, const Sample& middle, const Sample& fine, double p) {
  const double fine_power = std::pow(fine.step, p);
  const double middle_power = std::pow(middle.step, p);
  return (std::pow(coarse.step, p) - middle_power) / (middle_power - fine_power);
}

double observed_ratio(const Sample& coarse, const Sample& middle, const Sample& fine) {
  return (coarse.value - middle.value) / (middle.value - fine.value);
}

double range(const std::vector<Sample>& runs) {
  const auto [least, most] = std::minmax_element(
      runs.begin(), runs.end(), [](const Sample& a, const Sample& b) { return a.value < b.value; });
  return most->value - least->value;
}

/// At least as fast as errors of this power.
bool fall(const Sample& coarse, const Sample& middle, const Sample& fine, double power) {
  return observed_ratio(coarse, middle, fine) >= ratio_of_order(coarse, middle, fine, power);
}

/// At least as fast as errors of the lower power, and no faster than those of the higher.
bool fall_between(const Sample& coarse, const Sample& middle, const Sample& fine, double low,
                  double high) {
  return fall(coarse, middle, fine, low) &&
         observed_ratio(coarse, middle, fine) <= ratio_of_order(coarse, middle, fine, high);
}

bool show_order(const Sample& coarse, const Sample& middle, const Sample& fine, int order) {
  return fall_between(coarse, middle, fine, order - kBelow, order + kAbove) ||
         fall_between(coarse, middle, fine, order + 2 - kAbove, order + 2 + kAbove);
}

/// How far the limit of the finest three of four runs moves when the next power p + 4 is taken out
/// too, if that of the coarser three differs from it by this change.
double next_correction(const std::vector<Sample>& runs, int order, double change) {
  const auto rest = [order](const Sample* coarse) {
    const auto power = [&](int k) {
      return Sample{coarse[k].step, std::pow(coarse[k].step, order + 4)};
    };
    return extrapolated(power(0), power(1), power(2), order).value;
  };
  const Sample* const finest = &runs.back();
  const double before = rest(finest - 3);
  const double last = rest(finest - 2);
  return std::abs(change * last / (before - last));
}

}  // namespace

ConvergedValue extrapolated(const Sample& coarse, const Sample& middle, const Sample& fine,
                            int order) {
  struct Pair {
    double limit;  ///< of v∞ + A hᵖ
    double rest;   ///< what B hᵖ⁺² adds to it, for B = 1
  };
  const auto eliminate = [order](const Sample& a, const Sample& b) {
    const double a_power = std::pow(a.step, order);
    const double b_power = std::pow(b.step, order);
    const double over = a_power - b_power;
    return Pair{b.value + (b.value - a.value) * b_power / over,
                a_power * b_power * (b.step * b.step - a.step * a.step) / over};
  };
  const Pair first = eliminate(coarse, middle);
  const Pair second = eliminate(middle, fine);
  const double correction = (second.limit - first.limit) * second.rest / (first.rest - second.rest);
  return {second.limit + correction, kExtrapolationMargin * std::abs(correction)};
}

ConvergedValue compared(const std::vector<Sample>& runs, double power) {
  const double coarseness = std::pow(runs.front().step / runs.back().step, power) - 1.0;
  return {runs.back().value, kPlainMargin * range(runs) / coarseness};
}

ConvergedValue compared_with_scatter(const std::vector<Sample>& runs) {
  const ConvergedValue ordered = compared(runs, 1.0);
  return {ordered.value, std::max(ordered.error, kPlainMargin * range(runs))};
}

ConvergedValue compared_if_all_fall(const std::vector<Sample>& runs, int order) {
  const double power = 0.5 * order;
  for (auto fine = runs.begin() + 2; fine != runs.end(); ++fine) {
    if (!fall(fine[-2], fine[-1], fine[0], power)) return compared_with_scatter(runs);
  }
  return compared({runs.end() - 3, runs.end()}, power);
}

bool may_show_order(const Sample& coarse, const Sample& middle, const Sample& fine, int order) {
  return fall_between(coarse, middle, fine, order - kFarBelow, order + 2 + kAbove);
}

ConvergedValue converged(const std::vector<Sample>& runs, int order) {
  const Sample* const finest = &runs.back();
  const double half = 0.5 * order;
  const double power = fall(finest[-2], finest[-1], finest[0], half) ? half : 1.0;
  const ConvergedValue plain = compared({runs.end() - 3, runs.end()}, power);
  const bool is_alone = runs.size() == 3;
  if (!(is_alone ? show_order : may_show_order)(finest[-2], finest[-1], finest[0], order)) {
    return plain;
  }
  ConvergedValue limit = extrapolated(finest[-2], finest[-1], finest[0], order);
  if (!is_alone) {
    if (!may_show_order(finest[-3], finest[-2], finest[-1], order)) return plain;
    const ConvergedValue before = extrapolated(finest[-3], finest[-2], finest[-1], order);
    const double refinement = std::cbrt(finest[-3].step / finest[0].step);
    const bool is_shown = show_order(finest[-3], finest[-2], finest[-1], order) &&
                          show_order(finest[-2], finest[-1], finest[0], order);
    const double gain = is_shown ? std::pow(refinement, order) - 1.0
                                 : (std::pow(refinement, order - kFarBelow) - 1.0) / kPlainMargin;
    const double change = limit.value - before.value;
    const double careful = std::max(kConfirmed * limit.error, std::abs(change) / gain);
    limit.error =
        is_shown
            ? std::clamp(kNextMargin * std::sqrt(careful * next_correction(runs, order, change)),
                         kLeastDoubt * careful, careful)
            : careful;
  }
  return limit.error <= plain.error ? limit : plain;
}

}  // namespace impact
