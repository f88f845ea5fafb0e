#include "integrators/sundials_stepper.hpp"

#include <algorithm>

/// Newton's linear algebra for SUNDIALS: the arrow matrix I - γJ of the controlled components as
/// the package's matrix, its decomposition as the package's linear solver. Quadratures q' = g(t, c)
/// are not unknowns: ARKODE takes them explicitly; for CVODE x_q = b_q + γ (g(c + x_c) - g(c)),
/// which is Newton's correction without linearization and keeps linear invariants exactly.
namespace adore::integrators {
namespace {

struct Content {
  explicit Content(std::shared_ptr<const ArrowShape> shape) : matrix(std::move(shape)) {}
  ArrowMatrix matrix;
  double gamma = 0.0;  ///< the matrix is I - gamma J
};
Content& content(SUNMatrix m) { return *static_cast<Content*>(m->content); }
ArrowMatrix& arrow(SUNMatrix m) { return content(m).matrix; }
SundialsStepper& owner(SUNLinearSolver s) { return *static_cast<SundialsStepper*>(s->content); }

SUNMatrix_ID matrix_id(SUNMatrix) { return SUNMATRIX_CUSTOM; }
int matrix_zero(SUNMatrix m) {
  arrow(m).set_zero();
  return 0;
}
int matrix_copy(SUNMatrix from, SUNMatrix to) {
  arrow(to).copy_values(arrow(from));
  return 0;
}
int matrix_scale_add_identity(double factor, SUNMatrix m) {
  arrow(m).scale_and_add_identity(factor);
  content(m).gamma = -factor;
  return 0;
}
void matrix_destroy(SUNMatrix m) {
  delete static_cast<Content*>(m->content);
  m->content = nullptr;
  SUNMatFreeEmpty(m);
}
SUNMatrix matrix_clone(SUNMatrix m);

SUNMatrix new_matrix(std::shared_ptr<const ArrowShape> shape, SUNContext context) {
  SUNMatrix m = SUNMatNewEmpty(context);
  if (!m) return nullptr;
  m->content = new Content(std::move(shape));
  m->ops->getid = matrix_id;
  m->ops->clone = matrix_clone;
  m->ops->destroy = matrix_destroy;
  m->ops->zero = matrix_zero;
  m->ops->copy = matrix_copy;
  m->ops->scaleaddi = matrix_scale_add_identity;
  return m;
}

SUNMatrix matrix_clone(SUNMatrix m) { return new_matrix(arrow(m).shared_shape(), m->sunctx); }

SUNLinearSolver_Type solver_type(SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; }
SUNLinearSolver_ID solver_id(SUNLinearSolver) { return SUNLINEARSOLVER_CUSTOM; }
int solver_setup(SUNLinearSolver, SUNMatrix m) {
  return arrow(m).factor() ? 0 : SUNLS_LUFACT_FAIL;  // the package retries with another step
}
int solver_solve(SUNLinearSolver s, SUNMatrix m, N_Vector x, N_Vector b, double) {
  N_VScale(1.0, b, x);
  double* values = N_VGetArrayPointer(x);
  arrow(m).solve(values);
  switch (owner(s).correct_quadratures(values, content(m).gamma)) {
    case Outcome::Ok:
      return 0;
    case Outcome::Fail:
      return SUNLS_PSOLVE_FAIL_UNREC;
    case Outcome::Retry:
    case Outcome::NotFinite:
      break;
  }
  return SUNLS_PSOLVE_FAIL_REC;
}
sunindextype solver_last_flag(SUNLinearSolver) { return 0; }
int solver_free(SUNLinearSolver s) {
  if (s) SUNLinSolFreeEmpty(s);
  return 0;
}

}  // namespace

void SundialsStepper::make_newton_tools(RhsPart part) {
  jacobian_ = ArrowJacobian(*system_, part);
  matrix_.reset(new_matrix(jacobian_.shape(), context_.get()));
  SUNLinearSolver solver = SUNLinSolNewEmpty(context_.get());
  if (!matrix_ || !solver)
    throw_setup_failure("there is not enough memory for the Jacobian", "Use an explicit method.");
  solver->content = this;
  solver->ops->gettype = solver_type;
  solver->ops->getid = solver_id;
  solver->ops->setup = solver_setup;
  solver->ops->solve = solver_solve;
  solver->ops->lastflag = solver_last_flag;
  solver->ops->free = solver_free;
  linear_solver_.reset(solver);
}

int SundialsStepper::jacobian(double t, N_Vector y, N_Vector f, SUNMatrix J, void* self, N_Vector,
                              N_Vector, N_Vector) noexcept {
  auto& me = *static_cast<SundialsStepper*>(self);
  const long before = me.jacobian_.evaluations();
  const Outcome outcome = me.jacobian_(t, N_VGetArrayPointer(y), N_VGetArrayPointer(f), arrow(J));
  ++me.counters_.jacobians;
  if (me.jacobian_.part() == RhsPart::Whole) {
    me.counters_.evaluations += me.jacobian_.evaluations() - before;
  }
  return me.report(outcome);
}

// The package has just evaluated the residual at the iterate that x corrects: the point seen last.
// γ is that of the matrix, as in x_c.
Outcome SundialsStepper::correct_quadratures(double* x, double gamma) {
  const auto controlled = static_cast<std::size_t>(system_->controlled_size());
  if (!newton_moves_quadratures() || controlled == state_.size()) return Outcome::Ok;
  for (std::size_t i = 0; i < controlled; ++i) scratch_y_[i] = cached_state_[i] + x[i];
  const Outcome outcome = evaluate_(cached_time_, scratch_y_.data(), scratch_f_.data());
  if (outcome != Outcome::Ok) {
    static_cast<void>(report(outcome));
    return outcome;
  }
  for (std::size_t i = controlled; i < state_.size(); ++i) {
    x[i] += gamma * (scratch_f_[i] - cached_rhs_[i]);
  }
  return Outcome::Ok;
}

}  // namespace adore::integrators
