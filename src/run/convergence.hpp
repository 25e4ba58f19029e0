#pragma once

#include <limits>
#include <optional>
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

/// The number that at least three runs, from coarse to fine, give together.
///
/// Without an order: all runs compared_with_scatter().
///
/// With an order p: the finest three extrapolated(), if they show it. They do if the observed order
/// is p − 0.25 … p + 0.5, or p + 1.5 … p + 2.5 where the error of order p happens to vanish. Of
/// four runs the coarser three have to show it too, since one set of three may do so by chance. The
/// error is then that of limits which themselves converge with order p, by the mean ratio of the
/// four steps, since each limit rests on three of them; and no less than 0.15 times that of the
/// finest three alone. If the order is not shown, or if its error is smaller: the finest three
/// compared(), by the power p/2 if they fall at least so fast, else 1.
ConvergedValue converged(const std::vector<Sample>& runs, std::optional<int> order);

}  // namespace impact
