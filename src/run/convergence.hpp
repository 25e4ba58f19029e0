#pragma once

#include <limits>
#include <vector>

namespace impact {

/// A number as one of several runs of the same motion gives it.
struct Sample {
  double step;  ///< of the run, or what stands for it: errors vanish with it
  double value;
};

/// A number and a bound of its error.
struct ConvergedValue {
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();
};

/// Factor on the differences between runs that show no order.
constexpr double kPlainMargin = 3.0;
/// Factor on the difference between two columns of an extrapolation.
constexpr double kExtrapolationMargin = 2.0;

/// The limit of v∞ + A hᵖ + B hᵖ⁺² through three runs, with the error
///   2 |v∞ − v∞′|,  v∞′: the limit of v∞ + A hᵖ through the finer two.
/// p: the order of a method whose error has powers p, p + 2, … of the step.
ConvergedValue extrapolated(const Sample& coarse, const Sample& middle, const Sample& fine,
                            int order);

/// The value of the finest run with an error that holds for errors of this power of the step and
/// more:
///   3 max |vᵢ − vⱼ|/((h_coarsest/h_finest)^power − 1).
ConvergedValue compared(const std::vector<Sample>& runs, double power);

/// The same for power 1 where values may scatter whatever the step: the error is no less than three
/// times their range.
ConvergedValue compared_with_scatter(const std::vector<Sample>& runs);

/// Of runs that may scatter, of a method of order p: the finest three compared() by the power p/2
/// if all of them fall at least so fast from each to the next, which five that scatter hardly ever
/// do; else all compared_with_scatter().
ConvergedValue compared_if_all_fall(const std::vector<Sample>& runs, int order);

/// Whether three runs, from coarse to fine, of a method of order p may turn out to show it when a
/// fourth is there: their values fall as errors of a power between p − 1 and p + 2.5 do. Errors of
/// the powers p and p + 2 come near to p − 1 where they have opposite signs.
bool may_show_order(const Sample& coarse, const Sample& middle, const Sample& fine, int order);

/// The number that at least three runs, from coarse to fine, of a method of order p give together.
///
/// Three: extrapolated(), if they show the order. They do if the observed order is
/// p − 0.25 … p + 0.5, or p + 1.5 … p + 2.5 where the error of order p happens to vanish.
///
/// Four or more: the finest three extrapolated(), if they and the three before may_show_order().
/// The error is then that of limits which themselves converge with order p, by the mean ratio of
/// the four steps, since each limit rests on three of them; if not both show the order, three times
/// that of limits which converge with order p − 1; and no less than 0.15 times that of the finest
/// three alone. If both do, this is mostly far above what hᵖ⁺⁴, taken out too, changes of the
/// limit, which is about its error, but small by chance now and then: three times their geometric
/// mean counts, within 0.05 … 1 of the former.
///
/// Else, or where this has the smaller error: the finest three compared(), by the power p/2 if they
/// fall at least so fast, else 1.
ConvergedValue converged(const std::vector<Sample>& runs, int order);

}  // namespace impact
