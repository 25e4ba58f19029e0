#pragma once

#include <string>
#include <vector>

#include "theory/hertz.hpp"

namespace impact {

/// A measured point of a law y(x).
struct DataPoint {
  double x = 0.0;
  double y = 0.0;
  double standard_error = 1.0;  ///< of y; equal values mean an unweighted fit
};

/// A number and its standard error.
struct Estimate {
  double value = 0.0;
  double standard_error = 0.0;
};

/// The outcome of a least-squares fit. When the data cannot carry the law, `declined` says why and
/// there are no estimates.
struct Fit {
  std::string declined;
  std::vector<Estimate> parameters;
  double residual = 0.0;  ///< root mean square of y − law(x), unweighted
  double x_low = 0.0;     ///< range of the data used
  double x_high = 0.0;
  std::size_t points = 0;
};

/// No fit, for this reason.
Fit declined(const std::string& reason);

/// Fits b of eq. (2) to points (P, ξ).
Fit fit_hertz(const std::vector<DataPoint>& points, const ElasticDisk& disk);

/// Fits (d₁, d₂) of eq. (5) to points (v/c_s, e). Declined when there are fewer than four points,
/// when there is strong evidence (6 in the Bayesian information criterion) for a straight line
/// e = α + β v, of as many parameters, so that e(v) lacks the law's convex shape (as without
/// damping), or when d₂ is not above zero by two standard errors.
///
/// Standard errors come from the scatter about the law, by GSL's multifit_nlinear (trust region,
/// Levenberg–Marquardt).
Fit fit_restitution(const std::vector<DataPoint>& points);

}  // namespace impact
