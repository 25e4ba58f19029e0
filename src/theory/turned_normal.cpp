#include "theory/turned_normal.hpp"

namespace impact {
namespace {

/// The impulse along y over that of a level surface with the same restitution.
double impulse_by_level_one(double slope, double tan_gamma) {
  return (1.0 + slope * tan_gamma) / (1.0 + slope * slope);
}

}  // namespace

double restitution_on_slope(double restitution_along_normal, double slope, double tan_gamma) {
  return (1.0 + restitution_along_normal) * impulse_by_level_one(slope, tan_gamma) - 1.0;
}

double restitution_along_normal(double restitution, double slope, double tan_gamma) {
  return (1.0 + restitution) / impulse_by_level_one(slope, tan_gamma) - 1.0;
}

}  // namespace impact
