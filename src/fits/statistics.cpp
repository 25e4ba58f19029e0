#include "fits/statistics.hpp"

#include <gsl/gsl_statistics_double.h>

#include <cmath>

namespace impact {

MeanPoint mean_point(double x, const std::vector<double>& values) {
  const double mean = gsl_stats_mean(values.data(), 1, values.size());
  if (values.size() == 1) return {x, mean, std::nan(""), 1};
  const double scatter = gsl_stats_sd_m(values.data(), 1, values.size(), mean);
  return {x, mean, scatter / std::sqrt(static_cast<double>(values.size())), values.size()};
}

double jackknife_error(const std::vector<double>& estimates) {
  const auto n = static_cast<double>(estimates.size());
  return (n - 1.0) / std::sqrt(n) * gsl_stats_sd(estimates.data(), 1, estimates.size());
}

double quantile(const std::vector<double>& rising, double q) {
  if (rising.empty()) return std::nan("");
  return gsl_stats_quantile_from_sorted_data(rising.data(), 1, rising.size(), q);
}

double median(std::vector<double> values) {
  return gsl_stats_median(values.data(), 1, values.size());
}

}  // namespace impact
