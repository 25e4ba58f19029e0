#include "theory/quasi_static.hpp"

#include <cmath>

namespace impact {
namespace {

constexpr double kDensity = M_1_PI;  // M/R²

}  // namespace

double sound_speed(double young_modulus) { return std::sqrt(young_modulus / kDensity); }

double contact_time(double sound_speed, double velocity) {
  return M_PI / sound_speed * std::sqrt(std::log(4.0 * sound_speed / velocity));
}

double closed_form_restitution(double d1, double d2, double velocity_by_sound_speed) {
  return d1 * std::sqrt(1.0 - d2 / std::sqrt(std::log(4.0 / velocity_by_sound_speed)));
}

double paper_d2(const QuasiStaticImpact& impact, double sound_speed) {
  return 2.0 * M_PI * impact.dissipation_time * impact.effective_modulus / (kDensity * sound_speed);
}

}  // namespace impact
