#pragma once

#include <cstddef>
#include <vector>

namespace impact {

/// The values measured at one abscissa, averaged.
struct MeanPoint {
  double x = 0.0;
  double y = 0.0;
  double standard_error = 0.0;  ///< of y, from the scatter of the values; NaN for one value
  std::size_t runs = 0;
};

/// @param values not empty
MeanPoint mean_point(double x, const std::vector<double>& values);

/// The jackknife's standard error of an estimate from n samples, √((n − 1)/n Σ (θ_i − θ̄)²).
/// @param estimates θ_i, each without one of the samples; two or more
double jackknife_error(const std::vector<double>& estimates);

/// Of rising values, that below which the part q of them lies; NaN of none.
double quantile(const std::vector<double>& rising, double q);

/// @param values not empty; of an even number the mean of the middle two
double median(std::vector<double> values);

}  // namespace impact
