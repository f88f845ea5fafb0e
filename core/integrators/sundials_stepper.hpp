#pragma once

#include "integrators/arrow_jacobian.hpp"
#include "integrators/step_tools.hpp"

#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sundials/sundials_nvector.h>

#include <memory>
#include <string>
#include <vector>

namespace adore::integrators {

enum class CvodeMethod : unsigned char { Adams, Bdf };
enum class ArkodeMethod : unsigned char { Explicit, DiagonallyImplicit, ImplicitExplicit };
std::unique_ptr<Stepper> make_cvode(std::string_view name, CvodeMethod method);
std::unique_ptr<Stepper> make_arkode(std::string_view name, ArkodeMethod method);

struct ContextDeleter {
  void operator()(SUNContext c) const noexcept { SUNContext_Free(&c); }
};
struct VectorDeleter {
  void operator()(N_Vector v) const noexcept { N_VDestroy(v); }
};
struct MatrixDeleter {
  void operator()(SUNMatrix m) const noexcept { SUNMatDestroy(m); }
};
struct LinearSolverDeleter {
  void operator()(SUNLinearSolver s) const noexcept { SUNLinSolFree(s); }
};
struct NonlinearSolverDeleter {
  void operator()(SUNNonlinearSolver s) const noexcept { SUNNonlinSolFree(s); }
};
template <class Handle, class Deleter>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Deleter>;
using SunContext = Owned<SUNContext, ContextDeleter>;
using SunVector = Owned<N_Vector, VectorDeleter>;
using SunMatrix = Owned<SUNMatrix, MatrixDeleter>;
using SunLinearSolver = Owned<SUNLinearSolver, LinearSolverDeleter>;
using SunNonlinearSolver = Owned<SUNNonlinearSolver, NonlinearSolverDeleter>;

/// Common part of the SUNDIALS packages: error norm, right-hand side at the C interface, minimum
/// steps, projection, diagnosis. The package itself is behind the few protected functions.
///
/// Error norm: the vectors carry their own norm, max |e_i| w_i with w_i = 1 / (scale_i tol) and 0
/// for quadratures, so the tolerance means the same as in our own methods and quadratures control
/// nothing, Newton's convergence included.
///
/// Newton: iterated until its error is below a tenth of the error estimates of the steps before,
/// and at most 1e-4 of the tolerance. The packages' rule, a tenth of the tolerance, lets it be
/// the largest error of a step that stpMax bounds, with one sign for thousands of steps (decision
/// 415).
///
/// Minimum step: the packages stop when a step of the minimum size fails. It is then repeated from
/// the last state with a tolerance ten times wider, and wider again, until it passes: accepted
/// with any error, and counted. CVODE then begins again at order 1, so such steps are poor.
class SundialsStepper : public Stepper {
 public:
  SundialsStepper(std::string name, int order) : name_(std::move(name)), order_(order) {}

  [[nodiscard]] std::string_view name() const noexcept final { return name_; }
  [[nodiscard]] int order() const noexcept final { return order_; }
  void start(OdeSystem& system, double t0, std::span<const double> y0,
             const StepControl& control) final;
  [[nodiscard]] Memory memory() const final;
  /// The packages give their past to nobody: starts with the next step.
  void resume(OdeSystem& system, double t0, std::span<const double> y0, const StepControl& control,
              const Memory& memory) final;
  StepInfo step(double t_stop) final;
  [[nodiscard]] double time() const noexcept final { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept final { return state_; }
  /// Evaluated at the first call after a step, for the packages keep no derivative of the projected
  /// state.
  [[nodiscard]] std::span<const double> derivative() const noexcept final;
  [[nodiscard]] const Counters& counters() const noexcept final { return counters_; }

  /// For the linear solver: quadratures of a Newton correction x by a matrix I - gamma J.
  [[nodiscard]] Outcome correct_quadratures(double* x, double gamma);

 protected:
  static constexpr int kMostIterations = 8;  ///< of Newton in a stage; the packages' own is 3
  /// Result of one call of the package.
  enum class AdvanceResult : unsigned char { Done, ErrorTooLarge, NotConverged, Refused, Failed };
  struct Statistics {
    long rejected = 0;
    long nonlinear_iterations = 0;
  };
  /// Creates the package's memory for the system; vector_ has the start state.
  /// @throws StepFailure when the package does not support the settings.
  virtual void create() = 0;
  /// Starts afresh from (t_, vector_) with this first step.
  virtual void restart(double h) = 0;
  /// One internal step, not beyond t_stop; sets t_, vector_ and last_status_.
  virtual AdvanceResult advance(double t_stop) = 0;
  [[nodiscard]] virtual double next_step() const = 0;
  /// Local error of the last step into `error`; false when there is no estimate.
  virtual bool local_error(N_Vector error) = 0;
  /// From the next step on Newton's iteration ends when its error is below this share of the
  /// tolerance.
  virtual void set_newton_tolerance(double share) { (void)share; }
  /// Since the last create() or restart().
  [[nodiscard]] virtual Statistics statistics() const = 0;
  /// Does the package itself project the state with which it continues?
  [[nodiscard]] virtual bool has_own_projection() const { return false; }

  [[nodiscard]] bool has_constant_step() const noexcept {
    return control_.minimum == control_.maximum;
  }
  /// Fails with the package's words when a set-up call did not return 0.
  void check(int status, std::string_view call) const;
  [[noreturn]] void throw_setup_failure(std::string cause, std::string remedy) const;

  /// Are quadratures among the unknowns of Newton's iteration?
  [[nodiscard]] virtual bool newton_moves_quadratures() const { return false; }

  /// Matrix and solver of the Newton iteration for one part of the right-hand side: LU of the arrow
  /// of the controlled components.
  void make_newton_tools(RhsPart part);

  // Callbacks; `self` is the SundialsStepper. Parts that add up to the whole: controlled and
  // quadratures, stiff and rest.
  static int full_rhs(double t, N_Vector y, N_Vector dydt, void* self) noexcept;
  static int cached_rhs(double t, N_Vector y, N_Vector dydt, void* self) noexcept;
  static int controlled_rhs(double t, N_Vector y, N_Vector dydt, void* self) noexcept;
  static int quadrature_rhs(double t, N_Vector y, N_Vector dydt, void* self) noexcept;
  static int stiff_rhs(double t, N_Vector y, N_Vector dydt, void* self) noexcept;
  static int nonstiff_rhs(double t, N_Vector y, N_Vector dydt, void* self) noexcept;
  static int error_weights(N_Vector y, N_Vector weights, void* self) noexcept;
  static int project_vector(double t, N_Vector y, void* self) noexcept;
  static int jacobian(double t, N_Vector y, N_Vector f, SUNMatrix J, void* self, N_Vector, N_Vector,
                      N_Vector) noexcept;
  static void keep_message(int code, const char* module, const char* function, char* message,
                           void* self) noexcept;

  SunContext context_;
  SunVector vector_;
  SunMatrix matrix_;
  SunLinearSolver linear_solver_;
  SunNonlinearSolver nonlinear_solver_;
  OdeSystem* system_ = nullptr;
  StepControl control_;
  double t_ = 0.0;
  double initial_step_ = 0.0;  ///< first step after create()

 private:
  /// The whole right-hand side at (t, y) into cached_rhs_, unless it is there already: the packages
  /// ask for its parts one after the other.
  int update_cached_rhs(double t, const double* y) noexcept;
  int report(Outcome outcome) noexcept;
  void begin_afresh(double h);
  void advance_or_throw(double t_stop, bool& at_minimum);
  void project_accepted_state();
  void update_newton_tolerance(double error);
  void gather_statistics();
  [[noreturn]] void give_up(AdvanceResult advance, double h) const;
  [[nodiscard]] double estimate_first_step();

  std::string name_;
  int order_ = 0;
  mutable Evaluator evaluate_;
  mutable Counters counters_;
  Statistics statistics_before_restart_;
  std::vector<double> state_;
  mutable std::vector<double> derivative_;
  mutable bool derivative_is_current_ = false;
  std::vector<double> weights_;  ///< 1 / (scale * tolerance); 0 for quadratures
  std::vector<double> scratch_y_, scratch_f_;
  ArrowJacobian jacobian_;
  bool has_cached_rhs_ =
      false;  ///< cached_rhs_ is the right-hand side at (cached_time_, cached_state_)
  double cached_time_ = 0.0;
  std::vector<double> cached_state_, cached_rhs_;
  SunVector error_;
  double expected_error_ = 0.0;             ///< error of the coming step over the tolerance
  double tolerance_factor_ = 1.0;           ///< the tolerance is this much wider just now
  Outcome last_rhs_failure_ = Outcome::Ok;  ///< last refusal of the right-hand side
  std::string message_;                     ///< last words of the package
};

}  // namespace adore::integrators
