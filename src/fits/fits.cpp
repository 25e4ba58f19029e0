#include "fits/fits.hpp"

#include <fmt/format.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "theory/quasi_static.hpp"

namespace impact {
namespace {

/// Difference of the Bayesian information criterion that counts as strong (R. E. Kass and A. E.
/// Raftery, J. Am. Stat. Assoc. 90 (1995) 773).
constexpr double kStrongEvidence = 6.0;

using Law = std::function<double(const gsl_vector* parameters, double x)>;

struct Problem {
  const std::vector<DataPoint>* points;
  const Law* law;
};

int residuals(const gsl_vector* parameters, void* data, gsl_vector* result) {
  const auto& problem = *static_cast<const Problem*>(data);
  for (std::size_t i = 0; i < problem.points->size(); ++i) {
    const DataPoint& point = (*problem.points)[i];
    const double value = (*problem.law)(parameters, point.x) - point.y;
    if (!std::isfinite(value)) return GSL_EDOM;
    gsl_vector_set(result, i, value);
  }
  return GSL_SUCCESS;
}

using Vector = std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)>;
using Matrix = std::unique_ptr<gsl_matrix, decltype(&gsl_matrix_free)>;
using Workspace =
    std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)>;

Vector weights_of(const std::vector<DataPoint>& points) {
  Vector weights(gsl_vector_alloc(points.size()), &gsl_vector_free);
  for (std::size_t i = 0; i < points.size(); ++i) {
    gsl_vector_set(weights.get(), i, std::pow(points[i].standard_error, -2));
  }
  return weights;
}

/// Standard errors are scaled by the scatter, √(χ²/(n − p)).
Fit least_squares(const std::vector<DataPoint>& points, const Law& law,
                  const std::vector<double>& start) {
  gsl_set_error_handler_off();
  Problem problem{&points, &law};
  gsl_multifit_nlinear_fdf functions{};
  functions.f = residuals;
  functions.n = points.size();
  functions.p = start.size();
  functions.params = &problem;

  gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  Workspace workspace(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, functions.n, functions.p),
      &gsl_multifit_nlinear_free);
  const gsl_vector_const_view first = gsl_vector_const_view_array(start.data(), start.size());
  const Vector weights = weights_of(points);
  if (gsl_multifit_nlinear_winit(&first.vector, weights.get(), &functions, workspace.get()) !=
      GSL_SUCCESS) {
    return declined("the law has no value at some of the points");
  }
  constexpr std::size_t kMostIterations = 200;
  constexpr double kTolerance = 1e-12;
  int info = 0;
  const int status = gsl_multifit_nlinear_driver(kMostIterations, kTolerance, kTolerance, 0.0,
                                                 nullptr, nullptr, &info, workspace.get());
  if (status != GSL_SUCCESS && status != GSL_ENOPROG) {
    return declined(std::string("no least-squares solution: ") + gsl_strerror(status));
  }

  Matrix covariance(gsl_matrix_alloc(functions.p, functions.p), &gsl_matrix_free);
  gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(workspace.get()), 0.0, covariance.get());
  const gsl_vector* const weighted = gsl_multifit_nlinear_residual(workspace.get());
  double chi_squared = 0.0;
  gsl_blas_ddot(weighted, weighted, &chi_squared);
  const double scatter = chi_squared / static_cast<double>(functions.n - functions.p);

  Fit fit;
  const gsl_vector* const solution = gsl_multifit_nlinear_position(workspace.get());
  for (std::size_t k = 0; k < functions.p; ++k) {
    fit.parameters.push_back(
        {gsl_vector_get(solution, k), std::sqrt(scatter * gsl_matrix_get(covariance.get(), k, k))});
  }
  double sum = 0.0;
  for (const DataPoint& point : points) sum += std::pow(law(solution, point.x) - point.y, 2);
  fit.residual = std::sqrt(sum / static_cast<double>(points.size()));
  fit.points = points.size();
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(),
                          [](const DataPoint& a, const DataPoint& b) { return a.x < b.x; });
  fit.x_low = low->x;
  fit.x_high = high->x;
  return fit;
}

struct Line {
  double intercept = 0.0;
  double slope = 0.0;
};

Line straight_line(const std::vector<DataPoint>& points) {
  std::vector<double> x;
  std::vector<double> w;
  std::vector<double> y;
  for (const DataPoint& point : points) {
    x.push_back(point.x);
    w.push_back(std::pow(point.standard_error, -2));
    y.push_back(point.y);
  }
  Line line;
  double variance_intercept = 0.0;
  double covariance = 0.0;
  double variance_slope = 0.0;
  double chi_squared = 0.0;
  gsl_fit_wlinear(x.data(), 1, w.data(), 1, y.data(), 1, x.size(), &line.intercept, &line.slope,
                  &variance_intercept, &covariance, &variance_slope, &chi_squared);
  return line;
}

double straight_line_residual(const std::vector<DataPoint>& points) {
  const Line line = straight_line(points);
  double sum = 0.0;
  for (const DataPoint& point : points) {
    sum += std::pow(line.intercept + line.slope * point.x - point.y, 2);
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

/// (d₁, d₂) of the straight line that eq. (5) is in e² over 1/√ln(4 c_s/v). From there no step
/// leads out of the domain of the root, where the least-squares solver would be stuck.
std::vector<double> restitution_start(const std::vector<DataPoint>& points) {
  std::vector<DataPoint> straightened = points;
  for (DataPoint& point : straightened) {
    point.x = 1.0 / std::sqrt(std::log(4.0 / point.x));
    point.y *= point.y;
  }
  const Line line = straight_line(straightened);
  const bool has_root =
      line.intercept > 0.0 &&
      std::all_of(straightened.begin(), straightened.end(), [&line](const DataPoint& point) {
        return line.intercept + line.slope * point.x > 0.0;
      });
  if (!has_root) return {1.0, 0.0};
  return {std::sqrt(line.intercept), -line.slope / line.intercept};
}

}  // namespace

Fit declined(const std::string& reason) {
  Fit fit;
  fit.declined = reason;
  return fit;
}

Fit fit_hertz(const std::vector<DataPoint>& points, const ElasticDisk& disk) {
  if (points.size() < 2) return declined("fewer than two points");
  const Law law = [&disk](const gsl_vector* parameters, double force) {
    return hertz_compression(disk, gsl_vector_get(parameters, 0), force);
  };
  return least_squares(points, law, {1.0 - disk.poisson_ratio * disk.poisson_ratio});
}

Fit fit_restitution(const std::vector<DataPoint>& points) {
  if (points.size() < 4) return declined("fewer than four points");
  const Law law = [](const gsl_vector* parameters, double velocity) {
    return closed_form_restitution(gsl_vector_get(parameters, 0), gsl_vector_get(parameters, 1),
                                   velocity);
  };
  Fit fit = least_squares(points, law, restitution_start(points));
  if (!fit.declined.empty()) return fit;
  const double line = straight_line_residual(points);
  const double evidence = 2.0 * static_cast<double>(points.size()) * std::log(fit.residual / line);
  if (evidence > kStrongEvidence) {
    return declined(fmt::format(
        "a straight line fits better (residual {:.2g} against {:.2g}): e(v) lacks the convex shape "
        "of eq. (5)",
        line, fit.residual));
  }
  const Estimate& d2 = fit.parameters[1];
  if (d2.value <= 2.0 * d2.standard_error) {
    return declined(
        fmt::format("d2 = {:.2g} ± {:.2g} is not above zero", d2.value, d2.standard_error));
  }
  return fit;
}

}  // namespace impact
