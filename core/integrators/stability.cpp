#include "integrators/stability.hpp"

#include "integrators/predictor_corrector.hpp"
#include "integrators/tableau.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <arkode/arkode_arkstep.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <string>

namespace adore::integrators {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::MatrixXcd;

double spectral_radius(const Matrix& m) {
  return Eigen::ComplexEigenSolver<Matrix>(m, false).eigenvalues().cwiseAbs().maxCoeff();
}

double amplification_explicit(const Tableau& tableau, Complex z) {
  std::array<Complex, kMaxStages> k{};
  Complex end = 1.0;
  for (int s = 0; s < tableau.stages; ++s) {
    Complex y = 1.0;
    for (int j = 0; j < s; ++j) y += tableau.a[s][j] * k[j];
    k[s] = z * y;
    end += tableau.b[s] * k[s];
  }
  return std::abs(end);
}

double amplification_of_table(ARKodeButcherTable table, Complex z) {
  const int n = table->stages;
  Matrix m = Matrix::Identity(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) m(i, j) -= z * table->A[i][j];
  const Eigen::VectorXcd k = m.partialPivLu().solve(Eigen::VectorXcd::Ones(n));
  Complex end = 1.0;
  for (int i = 0; i < n; ++i) end += z * table->b[i] * k[i];
  ARKodeButcherTable_Free(table);
  return std::abs(end);
}

// State: y_n and the k - 1 derivatives before it, each times h: what PredictorCorrector keeps.
double amplification_pece(int k, Complex z) {
  std::array<double, kMaxAdamsOrder> times{};
  for (int j = 0; j < k; ++j) times[j] = -j;
  const AdamsWeights w = adams_weights(times.data(), k, 1.0);
  Matrix m = Matrix::Zero(k, k);
  // Rows of the two combinations over the state; f_n = z y_n.
  Eigen::RowVectorXcd predicted(k), surprise(k);
  predicted(0) = 1.0 + w.predict[0] * z;
  for (int j = 1; j < k; ++j) predicted(j) = w.predict[j];
  surprise = z * predicted;
  surprise(0) -= w.extrapolate[0] * z;
  for (int j = 1; j < k; ++j) surprise(j) -= w.extrapolate[j];
  m.row(0) = predicted + w.correct * surprise;
  if (k > 1) m(1, 0) = z;
  for (int j = 2; j < k; ++j) m(j, j - 1) = 1.0;
  return spectral_radius(m);
}

// Nordsieck array of order q: predicted by Pascal's triangle; one fixed-point iteration adds
// l e, e = h f(y*) - z₁*, l normalized to l₁ = 1. l(x) = ∫ Π (1 + u/j) du / norm, from -1 to x.
double amplification_cvode_adams(int q, Complex z) {
  std::vector<double> product{1.0};  // Π_{j=1}^{q-1} (1 + u/j)
  for (int j = 1; j < q; ++j) {
    product.push_back(0.0);
    for (std::size_t i = product.size() - 1; i > 0; --i) product[i] += product[i - 1] / j;
  }
  std::vector<double> l(static_cast<std::size_t>(q) + 1, 0.0);
  double at_minus_one = 0.0;
  for (int i = 0; i < q; ++i) {
    l[i + 1] = product[i] / (i + 1);
    at_minus_one += l[i + 1] * ((i + 1) % 2 == 0 ? 1.0 : -1.0);
  }
  l[0] = -at_minus_one;
  Matrix m = Matrix::Zero(q + 1, q + 1);
  for (int i = 0; i <= q; ++i) {
    double binomial = 1.0;
    for (int j = i; j <= q; ++j) {
      m(i, j) = binomial;
      binomial = binomial * (j + 1) / (j + 1 - i);
    }
  }
  const Eigen::RowVectorXcd e = z * m.row(0) - m.row(1);
  for (int i = 0; i <= q; ++i) m.row(i) += l[i] / l[1] * e;
  return spectral_radius(m);
}

// Σ_{m=1}^{q} ∇^m y / m = z y.
double amplification_bdf(int q, Complex z) {
  std::vector<double> c(static_cast<std::size_t>(q) + 1, 0.0);
  for (int m = 1; m <= q; ++m) {
    double binomial = 1.0;
    for (int j = 0; j <= m; ++j) {
      c[j] += binomial / m;
      binomial = -binomial * (m - j) / (j + 1);
    }
  }
  Matrix a = Matrix::Zero(q, q);
  for (int j = 1; j <= q; ++j) a(0, j - 1) = -c[j] / (c[0] - z);
  for (int j = 1; j < q; ++j) a(j, j - 1) = 1.0;
  return spectral_radius(a);
}

int number_at_end(std::string_view method) { return method.back() - '0'; }

}  // namespace

double amplification(std::string_view method, double phase, int order, double damping) {
  const Complex z = damping < 1.0
                        ? Complex(-damping * phase, std::sqrt(1.0 - damping * damping) * phase)
                        : Complex(-(damping + std::sqrt(damping * damping - 1.0)) * phase, 0.0);
  if (method.starts_with("rkf")) return amplification_explicit(fehlberg(number_at_end(method)), z);
  if (method == "rk4") return amplification_explicit(classical(), z);
  if (method.starts_with("pece")) return amplification_pece(number_at_end(method), z);
  if (method == "cvode-adams") return amplification_cvode_adams(order, z);
  if (method == "cvode-bdf") return amplification_bdf(order, z);
  if (method == "arkode-erk")
    return amplification_of_table(ARKodeButcherTable_LoadERK(ARKODE_DORMAND_PRINCE_7_4_5), z);
  if (method == "arkode-dirk")
    return amplification_of_table(ARKodeButcherTable_LoadDIRK(ARKODE_ARK436L2SA_DIRK_6_3_4), z);
  if (method == "arkode-imex")
    return amplification_of_table(ARKodeButcherTable_LoadDIRK(ARKODE_ARK437L2SA_DIRK_7_3_4), z);
  throw std::invalid_argument("there is no integrator \"" + std::string(method) + "\"");
}

}  // namespace adore::integrators
