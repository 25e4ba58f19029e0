#include "theory/hertz.hpp"

#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_lambert.h>

#include <cmath>

namespace impact {
namespace {

double relative_force(const ElasticDisk& disk, double force) {
  return force / (M_PI * disk.young_modulus);
}

}  // namespace

double hertz_compression(const ElasticDisk& disk, double b, double force) {
  const double p = b * relative_force(disk, force);
  return p * (std::log(4.0 / p) - 1.0 - disk.poisson_ratio);
}

double hertz_force(const ElasticDisk& disk, double b, double compression) {
  // With p = bP/(πE), L = ln 4 − 1 − ν and u = L − ln p, eq. (2) reads u exp(−u) = ξ exp(−L); the
  // rising branch has u > 1.
  const double l = std::log(4.0) - 1.0 - disk.poisson_ratio;
  const double argument = -compression * std::exp(-l);
  if (!(argument >= -std::exp(-1.0)) || compression < 0.0) return GSL_NAN;
  if (compression == 0.0) return 0.0;
  const double p = std::exp(l + gsl_sf_lambert_Wm1(argument));
  return p * M_PI * disk.young_modulus / b;
}

double inertial_load_compression(const ElasticDisk& disk, double force) {
  const double p = relative_force(disk, force);
  return p * (-std::log(p) - (1.0 + disk.poisson_ratio) / 4.0);
}

double contact_half_width(const ElasticDisk& disk, double force) {
  return std::sqrt(4.0 * relative_force(disk, force));
}

double contact_pressure(const ElasticDisk& disk, double force, double x) {
  const double a = contact_half_width(disk, force);
  const double inside = 1.0 - (x / a) * (x / a);
  return inside > 0.0 ? 2.0 * force / (M_PI * a) * std::sqrt(inside) : 0.0;
}

}  // namespace impact
