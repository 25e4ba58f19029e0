#include "theory/quasi_static.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace impact {
namespace {

constexpr double kTolerance = 1e-12;
constexpr double kDensity = M_1_PI;  // M/R²

/// Eq. (4) for y = (ξ, ξ′); free flight outside contact.
int acceleration(double /*time*/, const double* y, double* dydt, void* parameters) {
  const auto& impact = *static_cast<const QuasiStaticImpact*>(parameters);
  dydt[0] = y[1];
  dydt[1] = 0.0;
  if (y[0] > 0.0) {
    dydt[1] = -M_PI * impact.effective_modulus * (y[0] + impact.dissipation_time * y[1]) /
              std::log(4.0 / y[0]);
  }
  return GSL_SUCCESS;
}

using Driver = std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)>;

class Integration {
 public:
  explicit Integration(const QuasiStaticImpact& impact)
      : impact_(impact),
        system_{acceleration, nullptr, 2, &impact_},
        driver_(gsl_odeiv2_driver_alloc_y_new(&system_, gsl_odeiv2_step_rk8pd, kFirstStep,
                                              kTolerance * impact.velocity, kTolerance),
                &gsl_odeiv2_driver_free),
        state_{0.0, impact.velocity} {}

  void advance_to(double time) {
    if (gsl_odeiv2_driver_apply(driver_.get(), &time_, time, state_.data()) != GSL_SUCCESS) {
      throw std::runtime_error("eq. (4) could not be integrated");
    }
  }

  double time() const { return time_; }
  double compression() const { return state_[0]; }
  double velocity() const { return state_[1]; }

 private:
  static constexpr double kFirstStep = 1e-6;

  QuasiStaticImpact impact_;
  gsl_odeiv2_system system_;
  Driver driver_;
  double time_ = 0.0;
  std::array<double, 2> state_;
};

double velocity_at_zero_compression(Integration& integration, double interval) {
  while (integration.velocity() > 0.0) integration.advance_to(integration.time() + interval);
  // Newton's method in time, from the side of contact: ξ is nearly linear near its zero.
  constexpr double kNegligible = 1e-12;
  const double scale = integration.compression();
  while (integration.compression() > kNegligible * scale) {
    const double remaining = -integration.compression() / integration.velocity();
    integration.advance_to(integration.time() + std::min(remaining, interval));
  }
  return integration.velocity();
}

}  // namespace

double sound_speed(double young_modulus) { return std::sqrt(young_modulus / kDensity); }

double contact_time(double sound_speed, double velocity) {
  return M_PI / sound_speed * std::sqrt(std::log(4.0 * sound_speed / velocity));
}

double quasi_static_restitution(const QuasiStaticImpact& impact, EndOfImpact end,
                                double sound_speed) {
  Integration integration(impact);
  const double duration = contact_time(sound_speed, impact.velocity);
  if (end == EndOfImpact::kContactTime) {
    integration.advance_to(duration);
    return -integration.velocity() / impact.velocity;
  }
  return -velocity_at_zero_compression(integration, duration / 64.0) / impact.velocity;
}

double closed_form_restitution(double d1, double d2, double velocity_by_sound_speed) {
  return d1 * std::sqrt(1.0 - d2 / std::sqrt(std::log(4.0 / velocity_by_sound_speed)));
}

double paper_d2(const QuasiStaticImpact& impact, double sound_speed) {
  return 2.0 * M_PI * impact.dissipation_time * impact.effective_modulus / (kDensity * sound_speed);
}

}  // namespace impact
