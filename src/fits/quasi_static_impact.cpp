#include "fits/quasi_static_impact.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace impact {
namespace {

constexpr double kTolerance = 1e-12;

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
        state_{0.0, impact.velocity} {
    gsl_set_error_handler_off();
  }

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

struct WantedLoss {
  double effective_modulus;
  double velocity;
  double loss;
};

/// How much more than wanted is lost.
double excess_loss(double dissipation_time, void* parameters) {
  const auto& wanted = *static_cast<const WantedLoss*>(parameters);
  const double e =
      quasi_static_restitution({wanted.effective_modulus, dissipation_time, wanted.velocity},
                               EndOfImpact::kNoCompression, sound_speed(wanted.effective_modulus));
  return 1.0 - e * e - wanted.loss;
}

using RootSolver = std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)>;

/// The root of a function that changes its sign between `low` and `high`; NaN where it does not.
double brent_root(gsl_function& function, double low, double high) {
  constexpr int kMostIterations = 100;
  constexpr double kRootTolerance = 1e-10;
  const RootSolver solver(gsl_root_fsolver_alloc(gsl_root_fsolver_brent), &gsl_root_fsolver_free);
  if (gsl_root_fsolver_set(solver.get(), &function, low, high) != GSL_SUCCESS) return GSL_NAN;
  int status = GSL_CONTINUE;
  for (int k = 0; k < kMostIterations && status == GSL_CONTINUE; ++k) {
    if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS) return GSL_NAN;
    status = gsl_root_test_interval(gsl_root_fsolver_x_lower(solver.get()),
                                    gsl_root_fsolver_x_upper(solver.get()), 0.0, kRootTolerance);
  }
  return status == GSL_SUCCESS ? gsl_root_fsolver_root(solver.get()) : GSL_NAN;
}

}  // namespace

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

double dissipation_time(double effective_modulus, double velocity, double loss) {
  const double c = sound_speed(effective_modulus);
  if (loss == 0.0) return 0.0;
  if (!(loss > 0.0 && loss < 1.0 && velocity < c)) return GSL_NAN;
  gsl_set_error_handler_off();
  WantedLoss wanted{effective_modulus, velocity, loss};
  gsl_function function{&excess_loss, &wanted};
  // At the contact time the motion is overdamped: next to nothing comes back.
  return brent_root(function, 0.0, contact_time(c, velocity));
}

}  // namespace impact
