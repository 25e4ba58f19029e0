#include "reference/rk8pd.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace impact {
namespace {

constexpr double kFirstStep = 1e-3;  // of the time that the scales give

using Step = std::unique_ptr<gsl_odeiv2_step, decltype(&gsl_odeiv2_step_free)>;
using Control = std::unique_ptr<gsl_odeiv2_control, decltype(&gsl_odeiv2_control_free)>;
using Evolve = std::unique_ptr<gsl_odeiv2_evolve, decltype(&gsl_odeiv2_evolve_free)>;

}  // namespace

class Rk8pd::Solver {
 public:
  Solver(ForceField& field, const State& state, double tolerance, const Scales& scales)
      : form_(state.position.rows()),
        y_(size()),
        rate_(size()),
        system_{&Solver::rate, nullptr, size(), this},
        step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, size()), &gsl_odeiv2_step_free),
        control_(nullptr, &gsl_odeiv2_control_free),
        evolve_(gsl_odeiv2_evolve_alloc(size()), &gsl_odeiv2_evolve_free),
        inner_step_(kFirstStep * scales.length / scales.velocity) {
    gsl_set_error_handler_off();
    form_.scale(field, tolerance, scales, rate_.data());
    control_.reset(gsl_odeiv2_control_scaled_new(1.0, 0.0, 1.0, 0.0, rate_.data(), size()));
    take(state);
  }

  void take(const State& state) {
    form_.pack(state, y_.data());
    gsl_odeiv2_step_reset(step_.get());
    gsl_odeiv2_evolve_reset(evolve_.get());
  }

  Losses step(ForceField& field, State& state, double h, std::uint64_t most_inner_steps) {
    field_ = &field;
    const Losses before = form_.losses(y_.data());
    double time = 0.0;
    for (std::uint64_t inner_steps = 0; time < h; ++inner_steps) {
      if (inner_steps == most_inner_steps) throw std::runtime_error("rk8pd: too many steps");
      const int status = gsl_odeiv2_evolve_apply(evolve_.get(), control_.get(), step_.get(),
                                                 &system_, &time, h, &inner_step_, y_.data());
      if (status != GSL_SUCCESS) {
        throw std::runtime_error(std::string("rk8pd: ") + gsl_strerror(status));
      }
    }
    form_.unpack(y_.data(), state);
    form_.evaluate(field, y_.data(), rate_.data());
    const Losses after = form_.losses(y_.data());
    return {after.dissipated - before.dissipated, after.absorbed - before.absorbed};
  }

 private:
  std::size_t size() const { return static_cast<std::size_t>(form_.size()); }

  static int rate(double /*time*/, const double* y, double* rate, void* user) {
    Solver& solver = *static_cast<Solver*>(user);
    return solver.form_.evaluate(*solver.field_, y, rate) ? GSL_SUCCESS : GSL_FAILURE;
  }

  FirstOrderForm form_;
  ForceField* field_ = nullptr;
  std::vector<double> y_;
  std::vector<double> rate_;
  gsl_odeiv2_system system_;
  Step step_;
  Control control_;
  Evolve evolve_;
  double inner_step_;
};

Rk8pd::Rk8pd(double tolerance, const Scales& scales, std::uint64_t most_inner_steps)
    : tolerance_(tolerance), scales_(scales), most_inner_steps_(most_inner_steps) {}

Rk8pd::~Rk8pd() = default;

void Rk8pd::restart(ForceField& field, const State& state) {
  solver_ = std::make_unique<Solver>(field, state, tolerance_, scales_);
}

void Rk8pd::take_velocity(ForceField& /*field*/, const State& state) { solver_->take(state); }

Losses Rk8pd::step(ForceField& field, State& state, double h) {
  return solver_->step(field, state, h, most_inner_steps_);
}

double Rk8pd::step_limit(double /*omega_squared*/, double /*gamma*/) const {
  return std::numeric_limits<double>::infinity();
}

}  // namespace impact
