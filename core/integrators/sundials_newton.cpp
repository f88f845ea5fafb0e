#include "integrators/sundials_stepper.hpp"

#include <nvector/nvector_serial.h>
#include <sundials/sundials_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cmath>
#include <limits>

/// Newton's linear algebra for SUNDIALS. With quadratures q' = g(t, c) the matrix is
///   I - γJ = [ A  0 ]   so A x_c = b_c is solved by LU, and x_q = b_q - B x_c follows by
///   substitution.
///            [ B  I ]
namespace adore::integrators {
namespace {

struct BlockSolver {
  sunindextype controlled = 0;
  std::vector<sunindextype> pivots;
  sunindextype last_flag = 0;
};

BlockSolver& content(SUNLinearSolver s) { return *static_cast<BlockSolver*>(s->content); }

SUNLinearSolver_Type block_type(SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; }
SUNLinearSolver_ID block_id(SUNLinearSolver) { return SUNLINEARSOLVER_CUSTOM; }

int block_setup(SUNLinearSolver s, SUNMatrix matrix) {
  BlockSolver& block = content(s);
  if (block.controlled == 0) return 0;
  block.last_flag = SUNDlsMat_denseGETRF(SUNDenseMatrix_Cols(matrix), block.controlled,
                                         block.controlled, block.pivots.data());
  return block.last_flag > 0 ? 1 : 0;  // singular: the package retries with another step
}

int block_solve(SUNLinearSolver s, SUNMatrix matrix, N_Vector x, N_Vector b, double) {
  BlockSolver& block = content(s);
  const sunindextype nc = block.controlled;
  const sunindextype n = SUNDenseMatrix_Rows(matrix);
  N_VScale(1.0, b, x);
  double* values = N_VGetArrayPointer(x);
  if (nc > 0) {
    SUNDlsMat_denseGETRS(SUNDenseMatrix_Cols(matrix), nc, block.pivots.data(), values);
  }
  for (sunindextype j = 0; j < nc; ++j) {
    const double* column = SUNDenseMatrix_Column(matrix, j);
    const double factor = values[j];
    for (sunindextype i = nc; i < n; ++i) values[i] -= column[i] * factor;
  }
  return 0;
}

sunindextype block_last_flag(SUNLinearSolver s) { return content(s).last_flag; }

int block_free(SUNLinearSolver s) {
  if (!s) return 0;
  delete static_cast<BlockSolver*>(s->content);
  s->content = nullptr;
  SUNLinSolFreeEmpty(s);
  return 0;
}

}  // namespace

void SundialsStepper::make_newton_tools() {
  const int n = system_->size();
  const int nc = system_->controlled_size();
  matrix_.reset(SUNDenseMatrix(n, n, context_.get()));
  SUNLinearSolver solver = SUNLinSolNewEmpty(context_.get());
  if (!matrix_ || !solver) refuse("there is no memory for the Jacobian", "Use an explicit method.");
  auto block = std::make_unique<BlockSolver>();
  block->controlled = nc;
  block->pivots.resize(std::max(nc, 1));
  solver->content = block.release();
  solver->ops->gettype = block_type;
  solver->ops->getid = block_id;
  solver->ops->setup = block_setup;
  solver->ops->solve = block_solve;
  solver->ops->lastflag = block_last_flag;
  solver->ops->free = block_free;
  linear_solver_.reset(solver);
}

// Forward differences, one controlled column at a time; a point that the model refuses is tried on
// the other side.
int SundialsStepper::jacobian(Rhs rhs, double t, N_Vector y, N_Vector f, SUNMatrix J) {
  const sunindextype n = system_->size();
  const int nc = system_->controlled_size();
  const double* f0 = N_VGetArrayPointer(f);
  double* values = N_VGetArrayPointer(y);
  const double root = std::sqrt(std::numeric_limits<double>::epsilon());
  double* out = N_VGetArrayPointer(error_.get());  // free between steps
  ++counters_.jacobians;
  SUNMatZero(J);
  for (int j = 0; j < nc; ++j) {
    const double kept = values[j];
    double increment = root * std::max(std::abs(kept), system_->scales()[j]);
    int status = 0;
    for (int side = 0; side < 2; ++side, increment = -increment) {
      values[j] = kept + increment;
      status = rhs(t, y, error_.get(), this);
      if (status <= 0) break;
    }
    const double actual = values[j] - kept;
    values[j] = kept;
    if (status != 0) return status;
    double* column = SUNDenseMatrix_Column(J, j);
    for (sunindextype i = 0; i < n; ++i) column[i] = (out[i] - f0[i]) / actual;
  }
  return 0;
}

int SundialsStepper::full_jacobian(double t, N_Vector y, N_Vector f, SUNMatrix J, void* self,
                                   N_Vector, N_Vector, N_Vector) noexcept {
  return static_cast<SundialsStepper*>(self)->jacobian(full_rhs, t, y, f, J);
}

int SundialsStepper::stiff_jacobian(double t, N_Vector y, N_Vector f, SUNMatrix J, void* self,
                                    N_Vector, N_Vector, N_Vector) noexcept {
  return static_cast<SundialsStepper*>(self)->jacobian(stiff_rhs, t, y, f, J);
}

}  // namespace adore::integrators
