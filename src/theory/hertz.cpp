#include "theory/hertz.hpp"

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
