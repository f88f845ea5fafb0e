#include "integrators/sundials_stepper.hpp"

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_ls.h>

namespace adore::integrators {
namespace {

constexpr int order_of(ArkodeMethod method) { return method == ArkodeMethod::Explicit ? 5 : 4; }

/// SUNDIALS ARKODE: Dormand–Prince 5(4) explicit, a stiffly accurate singly diagonally implicit
/// pair 4(3), and the additive pair 4(3) of Kennedy and Carpenter that takes OdeSystem::rhs_stiff
/// implicitly and the rest explicitly. The implicit pair, too, is half of an additive pair of
/// Kennedy and Carpenter: the other half carries the quadratures, with the same weights at the same
/// stages, so that they are not unknowns of Newton's iteration. Supports a constant step, then
/// without an error estimate. Sources: [reynolds2023], [dormand1980], [kennedy2003], [kennedy2019].
class ArkodeStepper final : public SundialsStepper {
 public:
  ArkodeStepper(std::string name, ArkodeMethod method)
      : SundialsStepper(std::move(name), order_of(method)), method_(method) {}
  [[nodiscard]] bool can_hold_constant_step() const noexcept override { return true; }
  [[nodiscard]] std::string_view loses() const noexcept override {
    return "the error history of its step size control";
  }

 private:
  [[nodiscard]] ARKRhsFn explicit_part() const {
    switch (method_) {
      case ArkodeMethod::Explicit:
        return full_rhs;
      case ArkodeMethod::DiagonallyImplicit:
        return quadrature_rhs;
      case ArkodeMethod::ImplicitExplicit:
        break;
    }
    return nonstiff_rhs;
  }
  [[nodiscard]] ARKRhsFn implicit_part() const {
    switch (method_) {
      case ArkodeMethod::Explicit:
        return nullptr;
      case ArkodeMethod::DiagonallyImplicit:
        return controlled_rhs;
      case ArkodeMethod::ImplicitExplicit:
        break;
    }
    return stiff_rhs;
  }

  void set_table(void* m) {
    ARKODE_DIRKTableID implicit = ARKODE_DIRK_NONE;
    ARKODE_ERKTableID explicit_table = ARKODE_ERK_NONE;
    switch (method_) {
      case ArkodeMethod::Explicit:
        explicit_table = ARKODE_DORMAND_PRINCE_7_4_5;
        break;
      case ArkodeMethod::DiagonallyImplicit:
        implicit = ARKODE_ARK436L2SA_DIRK_6_3_4;
        explicit_table = ARKODE_ARK436L2SA_ERK_6_3_4;
        break;
      case ArkodeMethod::ImplicitExplicit:
        implicit = ARKODE_ARK437L2SA_DIRK_7_3_4;
        explicit_table = ARKODE_ARK437L2SA_ERK_7_3_4;
        break;
    }
    check(ARKStepSetTableNum(m, implicit, explicit_table), "ARKStepSetTableNum");
  }

  void create() override {
    if (method_ == ArkodeMethod::ImplicitExplicit && !system_->has_stiff_part()) {
      throw_setup_failure(
          "an implicit-explicit method needs the stiff part of the right-hand side separately, but "
          "this system does not provide it",
          "Choose arkode-dirk (all implicit), arkode-erk (all explicit) or another integrator.");
    }
    memory_.reset(
        ARKStepCreate(explicit_part(), implicit_part(), t_, vector_.get(), context_.get()));
    void* m = memory_.get();
    if (!m) throw_setup_failure("ARKODE could not be set up", "Choose another integrator.");
    check(ARKStepSetErrHandlerFn(m, keep_message, this), "ARKStepSetErrHandlerFn");
    check(ARKStepSetUserData(m, this), "ARKStepSetUserData");
    check(ARKStepWFtolerances(m, error_weights), "ARKStepWFtolerances");
    set_table(m);
    if (method_ != ArkodeMethod::Explicit) {
      make_newton_tools(method_ == ArkodeMethod::DiagonallyImplicit ? RhsPart::Whole
                                                                    : RhsPart::Stiff);
      check(ARKStepSetLinearSolver(m, linear_solver_.get(), matrix_.get()),
            "ARKStepSetLinearSolver");
      check(ARKStepSetJacFn(m, jacobian), "ARKStepSetJacFn");
      // A constant step cannot be cut when Newton's iteration is slow.
      check(ARKStepSetMaxNonlinIters(m, has_constant_step() ? 20 : kMostIterations),
            "ARKStepSetMaxNonlinIters");
    }
    check(ARKStepSetPostprocessStepFn(m, project_vector), "ARKStepSetPostprocessStepFn");
    if (!has_constant_step()) {
      check(ARKStepSetMinStep(m, control_.minimum), "ARKStepSetMinStep");
      check(ARKStepSetMaxStep(m, control_.maximum), "ARKStepSetMaxStep");
      check(ARKStepSetInitStep(m, initial_step_), "ARKStepSetInitStep");
    }
    check(ARKStepSetMaxErrTestFails(m, 20), "ARKStepSetMaxErrTestFails");
    check(ARKStepSetMaxHnilWarns(m, -1), "ARKStepSetMaxHnilWarns");
  }

  void restart(double h) override {
    check(ARKStepReInit(memory_.get(), explicit_part(), implicit_part(), t_, vector_.get()),
          "ARKStepReInit");
    check(ARKStepSetInitStep(memory_.get(), h), "ARKStepSetInitStep");
  }

  AdvanceResult advance(double t_stop) override {
    if (has_constant_step()) {
      const bool last = reaches(t_, control_.maximum, t_stop);
      ARKStepSetFixedStep(memory_.get(), last ? t_stop - t_ : control_.maximum);
    }
    ARKStepSetStopTime(memory_.get(), t_stop);
    const int status = ARKStepEvolve(memory_.get(), t_stop, vector_.get(), &t_, ARK_ONE_STEP);
    switch (status) {
      case ARK_SUCCESS:
      case ARK_TSTOP_RETURN:
        return AdvanceResult::Done;
      case ARK_ERR_FAILURE:
        return AdvanceResult::ErrorTooLarge;
      case ARK_CONV_FAILURE:
        return AdvanceResult::NotConverged;
      case ARK_RHSFUNC_FAIL:
      case ARK_FIRST_RHSFUNC_ERR:
      case ARK_REPTD_RHSFUNC_ERR:
      case ARK_UNREC_RHSFUNC_ERR:
        return AdvanceResult::Refused;
      default:
        return AdvanceResult::Failed;
    }
  }

  [[nodiscard]] double next_step() const override {
    double h = 0.0;
    ARKStepGetCurrentStep(memory_.get(), &h);
    return h;
  }

  bool local_error(N_Vector error) override {
    return !has_constant_step() && ARKStepGetEstLocalErrors(memory_.get(), error) == 0;
  }

  void set_newton_tolerance(double share) override {
    if (method_ != ArkodeMethod::Explicit) ARKStepSetNonlinConvCoef(memory_.get(), share);
  }

  [[nodiscard]] bool has_own_projection() const override { return true; }

  [[nodiscard]] Statistics statistics() const override {
    long error_fails = 0;
    long convergence_fails = 0;
    long iterations = 0;
    ARKStepGetNumErrTestFails(memory_.get(), &error_fails);
    if (method_ != ArkodeMethod::Explicit) {
      ARKStepGetNumStepSolveFails(memory_.get(), &convergence_fails);
      ARKStepGetNumNonlinSolvIters(memory_.get(), &iterations);
    }
    return {error_fails + convergence_fails, iterations};
  }

  struct Free {
    void operator()(void* m) const noexcept { ARKStepFree(&m); }
  };
  ArkodeMethod method_;
  std::unique_ptr<void, Free> memory_;
};

}  // namespace

std::unique_ptr<Stepper> make_arkode(std::string_view name, ArkodeMethod method) {
  return std::make_unique<ArkodeStepper>(std::string(name), method);
}

}  // namespace adore::integrators
