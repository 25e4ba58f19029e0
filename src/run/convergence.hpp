#pragma once

#include <limits>
#include <optional>
#include <vector>

namespace impact {

/// A number that one of several runs of the same motion came to.
struct Sample {
  double step;  ///< of the run, or what stands for it: errors vanish with it
  double value;
};

/// A number and the size of error that it may have.
struct ConvergedValue {
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();
};

/// Differences between runs, from which no order can be seen, count so many times.
constexpr double kPlainMargin = 3.0;
/// The difference between two columns of an extrapolation counts so many times.
constexpr double kExtrapolationMargin = 2.0;

/// The limit of v∞ + A hᵖ + B hᵖ⁺² through three runs, with the error
///   2 |v∞ − v∞′|,  v∞′: the limit of v∞ + A hᵖ through the finer two.
/// p: the order of a method whose error has powers p, p + 2, … of the step.
ConvergedValue extrapolated(const Sample& coarse, const Sample& middle, const Sample& fine,
                            int order);

/// The value of the finest run with an error that holds for order 1 and more:
///   3 max |vᵢ − vⱼ|/(h_coarsest/h_finest − 1).
/// Where values may `scatter` whatever the step, it is no less than three times their range.
ConvergedValue compared(const std::vector<Sample>& runs, bool scatter);

/// What at least three runs, from coarse to fine, say of a number. Without an order all of them are
/// compared(). With one: extrapolated(), by the finest three, if they show that order p or, where
/// its error happens to vanish, the next one, by an observed order of p − 0.25 … p + 0.5 or
/// p + 1.5 … p + 2.5, and so do the three before, where there are four runs: after runs that did
/// not show an order one that does may be chance. Then the
/// error is no less than that of limits which themselves converge with order p. Otherwise, or if
/// that is the smaller error, the finest three compared().
ConvergedValue converged(const std::vector<Sample>& runs, std::optional<int> order);

}  // namespace impact
