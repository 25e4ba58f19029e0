#include "solvers/bdf.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "solvers/reduced_system.hpp"

namespace impact {
namespace {

constexpr int kDone = 0;
constexpr int kTryShorterStep = 1;
constexpr long kMostInnerSteps = 100000;  // in one step(), so that it ends

double* values(N_Vector vector) { return N_VGetArrayPointer(vector); }

struct Free {
  void operator()(SUNContext context) const { SUNContext_Free(&context); }
  void operator()(N_Vector vector) const { N_VDestroy(vector); }
  void operator()(SUNLinearSolver solver) const { SUNLinSolFreeEmpty(solver); }
};
struct FreeCvode {
  void operator()(void* cvode) const { CVodeFree(&cvode); }
};

template <class Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Free>;

Owned<SUNContext> make_context() {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  return Owned<SUNContext>(context);
}

/// What CVODE calls a preconditioner, and here is the solver itself.
struct Preconditioner {
  void* cvode;
  SUNPSetupFn set_up;
  SUNPSolveFn solve;
};

Preconditioner& preconditioner(SUNLinearSolver solver) {
  return *static_cast<Preconditioner*>(solver->content);
}

/// A linear solver that applies the preconditioner once and needs no product with the matrix.
Owned<SUNLinearSolver> make_solver(Preconditioner& content, SUNContext context) {
  SUNLinearSolver solver = SUNLinSolNewEmpty(context);
  solver->content = &content;
  solver->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_ITERATIVE; };
  solver->ops->setatimes = [](SUNLinearSolver, void*, SUNATimesFn) { return kDone; };
  solver->ops->setpreconditioner = [](SUNLinearSolver self, void* cvode, SUNPSetupFn set_up,
                                      SUNPSolveFn solve) {
    preconditioner(self) = {cvode, set_up, solve};
    return kDone;
  };
  solver->ops->setup = [](SUNLinearSolver self, SUNMatrix) {
    return preconditioner(self).set_up(preconditioner(self).cvode);
  };
  solver->ops->solve = [](SUNLinearSolver self, SUNMatrix, N_Vector z, N_Vector r,
                          realtype tolerance) {
    return preconditioner(self).solve(preconditioner(self).cvode, r, z, tolerance, SUN_PREC_LEFT);
  };
  return Owned<SUNLinearSolver>(solver);
}

}  // namespace

class Bdf::Solver {
 public:
  Solver(ForceField& field, const State& state, double tolerance, const Scales& scales)
      : form_(state.position.rows()),
        system_(field),
        linearised_(state),
        context_(make_context()),
        y_(N_VNew_Serial(form_.size(), context_.get())),
        rate_(N_VNew_Serial(form_.size(), context_.get())),
        linear_solver_(make_solver(preconditioner_, context_.get())),
        cvode_(CVodeCreate(CV_BDF, context_.get())) {
    void* const cvode = cvode_.get();
    CVodeSetErrHandlerFn(cvode, &Solver::take_message, this);
    CVodeSetUserData(cvode, this);
    form_.pack(state, values(y_.get()));
    CVodeInit(cvode, &Solver::evaluate, 0.0, y_.get());
    form_.scale(field, tolerance, scales, values(rate_.get()));
    CVodeSVtolerances(cvode, 0.0, rate_.get());
    CVodeSetStabLimDet(cvode, SUNTRUE);
    CVodeSetMaxNumSteps(cvode, kMostInnerSteps);
    CVodeSetLinearSolver(cvode, linear_solver_.get(), nullptr);
    CVodeSetPreconditioner(cvode, &Solver::factorise, &Solver::solve);
  }
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  void restart(const State& state) {
    form_.pack(state, values(y_.get()));
    losses_ = {};
    CVodeReInit(cvode_.get(), time_, y_.get());
  }

  Losses step(ForceField& field, State& state, double h) {
    field_ = &field;
    time_ += h;
    double reached = 0.0;
    if (CVode(cvode_.get(), time_, y_.get(), &reached, CV_NORMAL) < 0) {
      throw std::runtime_error("BDF: " + message_);
    }
    form_.unpack(values(y_.get()), state);
    form_.evaluate(field, values(y_.get()), values(rate_.get()));
    const Losses before = losses_;
    losses_ = form_.losses(values(y_.get()));
    return {losses_.dissipated - before.dissipated, losses_.absorbed - before.absorbed};
  }

 private:
  static Solver& self(void* user) { return *static_cast<Solver*>(user); }

  static int evaluate(realtype /*time*/, N_Vector y, N_Vector rate, void* user) {
    const bool finite = self(user).form_.evaluate(*self(user).field_, values(y), values(rate));
    return finite ? kDone : kTryShorterStep;
  }

  static int factorise(realtype /*time*/, N_Vector y, N_Vector /*rate*/, booleantype still_good,
                       booleantype* renewed, realtype gamma, void* user) {
    Solver& solver = self(user);
    *renewed = still_good == SUNTRUE ? SUNFALSE : SUNTRUE;
    if (*renewed == SUNTRUE) {
      solver.form_.unpack(values(y), solver.linearised_);
      solver.system_.set_stiffness(*solver.field_, solver.linearised_.position);
    }
    return solver.system_.factorise(gamma) ? kDone : kTryShorterStep;
  }

  static int solve(realtype /*time*/, N_Vector /*y*/, N_Vector /*rate*/, N_Vector r, N_Vector z,
                   realtype /*gamma*/, realtype /*delta*/, int /*side*/, void* user) {
    N_VScale(1.0, r, z);
    self(user).system_.solve(values(z));
    return kDone;
  }

  static void take_message(int /*code*/, const char* /*module*/, const char* /*function*/,
                           char* message, void* user) {
    self(user).message_ = message;
  }

  FirstOrderForm form_;
  ReducedSystem system_;
  State linearised_;  ///< where the stiffness was taken
  ForceField* field_ = nullptr;
  double time_ = 0.0;
  Losses losses_;  ///< up to `time_`
  std::string message_;
  Preconditioner preconditioner_{};
  Owned<SUNContext> context_;
  Owned<N_Vector> y_;
  Owned<N_Vector> rate_;
  Owned<SUNLinearSolver> linear_solver_;
  std::unique_ptr<void, FreeCvode> cvode_;
};

Bdf::Bdf(double tolerance, const Scales& scales) : tolerance_(tolerance), scales_(scales) {}

Bdf::~Bdf() = default;

void Bdf::restart(ForceField& field, const State& state) {
  solver_ = std::make_unique<Solver>(field, state, tolerance_, scales_);
}

void Bdf::take_velocity(ForceField& /*field*/, const State& state) { solver_->restart(state); }

Losses Bdf::step(ForceField& field, State& state, double h) {
  return solver_->step(field, state, h);
}

double Bdf::step_limit(double /*omega_squared*/, double /*gamma*/) const {
  return std::numeric_limits<double>::infinity();
}

}  // namespace impact
