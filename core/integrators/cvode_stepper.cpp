#include "integrators/sundials_stepper.hpp"

#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>
#include <sunnonlinsol/sunnonlinsol_newton.h>

#include <algorithm>

namespace adore::integrators {
namespace {

constexpr int kAdamsOrder = 12;
constexpr int kBdfOrder = 5;

/// SUNDIALS CVODE: variable-order, variable-step multistep methods in Nordsieck form. Adams with
/// fixed-point iteration, BDF with Newton. It chooses step and order together and cannot hold a
/// constant step. Source: [hindmarsh2005].
class CvodeStepper final : public SundialsStepper {
 public:
  CvodeStepper(std::string name, CvodeMethod method)
      : SundialsStepper(std::move(name), method == CvodeMethod::Adams ? kAdamsOrder : kBdfOrder),
        method_(method) {}
  [[nodiscard]] bool can_hold_constant_step() const noexcept override { return false; }
  [[nodiscard]] std::string_view loses() const noexcept override {
    return "its order and its past steps, and starts again at order 1";
  }

 private:
  void create() override {
    const bool bdf = method_ == CvodeMethod::Bdf;
    memory_.reset(CVodeCreate(bdf ? CV_BDF : CV_ADAMS, context_.get()));
    void* m = memory_.get();
    if (!m) throw_setup_failure("CVODE could not be set up", "Choose another integrator.");
    check(CVodeSetErrHandlerFn(m, keep_message, this), "CVodeSetErrHandlerFn");
    check(CVodeInit(m, bdf ? cached_rhs : full_rhs, t_, vector_.get()), "CVodeInit");
    check(CVodeSetUserData(m, this), "CVodeSetUserData");
    check(CVodeWFtolerances(m, error_weights), "CVodeWFtolerances");
    if (bdf) {
      make_newton_tools(RhsPart::Whole);
      nonlinear_solver_.reset(SUNNonlinSol_Newton(vector_.get(), context_.get()));
      check(CVodeSetNonlinearSolver(m, nonlinear_solver_.get()), "CVodeSetNonlinearSolver");
      check(CVodeSetLinearSolver(m, linear_solver_.get(), matrix_.get()), "CVodeSetLinearSolver");
      check(CVodeSetJacFn(m, jacobian), "CVodeSetJacFn");
      // Scaling the correction for a stale γ suits the stiff part; quadratures need the correction
      // itself.
      check(CVodeSetLinearSolutionScaling(m, SUNFALSE), "CVodeSetLinearSolutionScaling");
      check(CVodeSetMaxNonlinIters(m, kMostIterations), "CVodeSetMaxNonlinIters");
    } else {
      nonlinear_solver_.reset(SUNNonlinSol_FixedPoint(vector_.get(), 0, context_.get()));
      check(CVodeSetNonlinearSolver(m, nonlinear_solver_.get()), "CVodeSetNonlinearSolver");
    }
    if (control_.highest_order > 0)
      check(CVodeSetMaxOrd(m, std::min(control_.highest_order, order())), "CVodeSetMaxOrd");
    check(CVodeSetMinStep(m, control_.minimum), "CVodeSetMinStep");
    check(CVodeSetMaxStep(m, control_.maximum), "CVodeSetMaxStep");
    check(CVodeSetInitStep(m, initial_step_), "CVodeSetInitStep");
    check(CVodeSetMaxErrTestFails(m, 20), "CVodeSetMaxErrTestFails");
    check(CVodeSetMaxHnilWarns(m, -1), "CVodeSetMaxHnilWarns");
  }

  void restart(double h) override {
    check(CVodeReInit(memory_.get(), t_, vector_.get()), "CVodeReInit");
    check(CVodeSetInitStep(memory_.get(), h), "CVodeSetInitStep");
  }

  AdvanceResult advance(double t_stop) override {
    CVodeSetStopTime(memory_.get(), t_stop);
    const int status = CVode(memory_.get(), t_stop, vector_.get(), &t_, CV_ONE_STEP);
    switch (status) {
      case CV_SUCCESS:
      case CV_TSTOP_RETURN:
        return AdvanceResult::Done;
      case CV_ERR_FAILURE:
        return AdvanceResult::ErrorTooLarge;
      case CV_CONV_FAILURE:
        return AdvanceResult::NotConverged;
      case CV_RHSFUNC_FAIL:
      case CV_FIRST_RHSFUNC_ERR:
      case CV_REPTD_RHSFUNC_ERR:
      case CV_UNREC_RHSFUNC_ERR:
        return AdvanceResult::Refused;
      default:
        return AdvanceResult::Failed;
    }
  }

  [[nodiscard]] double next_step() const override {
    double h = 0.0;
    CVodeGetCurrentStep(memory_.get(), &h);
    return h;
  }

  bool local_error(N_Vector error) override {
    return CVodeGetEstLocalErrors(memory_.get(), error) == 0;
  }

  void set_newton_tolerance(double share) override {
    if (method_ == CvodeMethod::Bdf) CVodeSetNonlinConvCoef(memory_.get(), share);
  }

  [[nodiscard]] bool newton_moves_quadratures() const override {
    return method_ == CvodeMethod::Bdf;
  }

  [[nodiscard]] Statistics statistics() const override {
    long error_fails = 0;
    long convergence_fails = 0;
    long iterations = 0;
    CVodeGetNumErrTestFails(memory_.get(), &error_fails);
    CVodeGetNumStepSolveFails(memory_.get(), &convergence_fails);
    CVodeGetNumNonlinSolvIters(memory_.get(), &iterations);
    return {error_fails + convergence_fails, iterations};
  }

  struct Free {
    void operator()(void* m) const noexcept { CVodeFree(&m); }
  };
  CvodeMethod method_;
  std::unique_ptr<void, Free> memory_;
};

}  // namespace

std::unique_ptr<Stepper> make_cvode(std::string_view name, CvodeMethod method) {
  return std::make_unique<CvodeStepper>(std::string(name), method);
}

}  // namespace adore::integrators
